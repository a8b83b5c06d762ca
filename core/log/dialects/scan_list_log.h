#pragma once

#include <memory>
#include <string>

#include "core/log/log_builder.h"

// Scans alone, a line each, without odometry, as they are easily written out of a bag:
//
//   # angle_min -2.086214 angle_max 2.086214 angle_increment 0.00613592 scan_time 0.1 range_min
//   0.02
//     range_max 5.6                                                         (all in one line)
//   t n r…
//
// [rad], [s], [m]. A reading below range_min, 0 or nan says nothing; from range_max on, or inf,
// nothing was hit.

namespace mapbed {

std::unique_ptr<LogReader> make_scan_list_reader(const std::string& name,
                                                 const LogOptions& options);

}  // namespace mapbed
