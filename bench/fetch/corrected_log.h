#pragma once

#include <string>
#include <vector>

// CARMEN logs that GMapping has corrected, as they were published in place of the raw ones: the
// poses of a FLASER line are the filter's, and so are the ODOM lines, of which one follows after
// each scan and repeats its corrected pose. The odometry that the filter was given is in them all
// the same: the motion from each ODOM line to the next, but for the jump to the corrected pose.

namespace mapbed {

struct MadeFile;

struct CorrectedScan {
  double time = 0.0;      // [s]
  std::string readings;   // "180 6.66 6.86 …", as they stand in the log
  double odometry[3]{};   // x, y [m], theta [rad], chained from the first ODOM line on
  double corrected[3]{};  // the filter's pose
};

// Throws InputError with the line that is not of such a log.
std::vector<CorrectedScan> read_corrected_log(const std::string& path);

// A CARMEN log of these scans with their odometry: FLASER lines.
std::string chained_odometry(const std::vector<CorrectedScan>& scans, const MadeFile& made);

// The filter's poses, lines "t x y theta".
std::string corrected_poses(const std::vector<CorrectedScan>& scans, const MadeFile& made);

}  // namespace mapbed
