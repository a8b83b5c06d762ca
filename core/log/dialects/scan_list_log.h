#pragma once

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

struct LogDialect;
LogDialect scan_list_dialect();

}  // namespace mapbed
