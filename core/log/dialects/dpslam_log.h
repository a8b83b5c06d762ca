#pragma once

// Logs of DP-SLAM (Eliazar and Parr, 2003): pairs of lines
//
//   Odometry x y theta      [m], [rad]
//   Laser n r…              [m]
//
// without time stamps. Scan k gets k times the option scan_period, and its odometry the same.

namespace mapbed {

struct LogDialect;
LogDialect dpslam_dialect();

}  // namespace mapbed
