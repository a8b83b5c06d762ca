#pragma once

#include <memory>

#include "bench/sources/log_source.h"

namespace mapbed {

// Of settings with 'log'. Throws InputError.
SourcePlan plan_recorded(const Settings& settings, HashedFiles& files);

std::unique_ptr<LogSource> open_recorded(const RecordedPlan& plan, const GoesOn& goes_on);

// Whether the log itself tells the true path; reads it.
bool tells_truth(const RecordedPlan& plan);

}  // namespace mapbed
