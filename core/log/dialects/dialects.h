#pragma once

#include <span>

#include "core/log/log_reader.h"

namespace mapbed {

// All dialects, in the order in which they are asked whether a log is theirs.
std::span<const LogDialect> log_dialects();

}  // namespace mapbed
