#pragma once

// Logs of the CoreSLAM robot (Steux and El Hamzaoui, "tinySLAM", 2010): a line a scan, that ends in
// the 682 ranges [mm] of a Hokuyo URG-04LX. Two kinds of lines, told by the number of fields
// before the ranges:
//
//   25 fields   t[us] - left_ticks right_ticks …
//   13 fields   t[us] left_ticks right_ticks …    the right wheel counts backwards
//
// Odometry starts at the origin and follows the ticks along arcs. The scanner measures every
// 360/1024 deg from its step 44 to 725, the front being 384, up to 5.6 m; a reading below 20 mm is
// an error code or 0 and says nothing. It stands 0.145 m ahead of the robot's centre.

namespace mapbed {

struct LogDialect;
LogDialect coreslam_dialect();

}  // namespace mapbed
