#pragma once

#include <memory>
#include <string>

#include "core/log/log_builder.h"

// Logs of DP-SLAM (Eliazar and Parr, 2003): pairs of lines
//
//   Odometry x y theta      [m], [rad]
//   Laser n r…              [m]
//
// without time stamps. Scan k gets k times the option scan_period, and its odometry the same.

namespace mapbed {

std::unique_ptr<LogReader> make_dpslam_reader(const std::string& name, const LogOptions& options);

}  // namespace mapbed
