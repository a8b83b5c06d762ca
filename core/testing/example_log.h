#pragma once

#include "core/log/log_file.h"

namespace mapbed {

// The example log as it is in scenarios/logs/example.log.gz: the tour of test_room.h through the
// example place. Ranges and poses are rounded to the digits that logs have (ranges to 1 cm);
// that also hides the last bits in which mathematics libraries differ.
RecordedLog example_log();

}  // namespace mapbed
