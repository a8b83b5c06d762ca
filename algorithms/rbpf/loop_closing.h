#pragma once

#include <vector>

#include "core/config/option.h"
#include "core/geometry/pose2.h"

namespace mapbed {

// When a path comes back to where it was before, section 5.4.2: the robot enters an area that it
// knows from one that it does not, and its scan fits there. Only the entry counts: as long as the
// robot stays in known areas no further loop is closed.
struct LoopClosingOptions {
  double distance = 2.0;          // [m] from an earlier pose: the robot is back
  double path_between = 15.0;     // [m] of path since that pose at least
  double min_inlier_ratio = 0.6;  // of the scan by the map, before the robot is sure
};

template <class Visitor>
void visit_fields(LoopClosingOptions& o, Visitor&& visit) {
  visit("distance", o.distance, Unit::meter, kPositive, "from an earlier pose: the robot is back");
  visit("path_between", o.path_between, Unit::meter, kPositive,
        "path driven since that pose at least");
  visit("min_inlier_ratio", o.min_inlier_ratio, kFraction,
        "fraction of the scan that the map explains before the robot is sure");
}

// Whether the last pose of a path is back at an earlier one.
bool is_back(const std::vector<Pose2>& path, const LoopClosingOptions& options);

class LoopDetector {
 public:
  explicit LoopDetector(const LoopClosingOptions& options) : options_(options) {}

  // To be asked at every update, with the path so far and the fraction of the newest scan that the
  // map explains at its end. True where a loop is closed with this scan.
  bool closes(const std::vector<Pose2>& path, double inlier_ratio);

 private:
  LoopClosingOptions options_;
  bool knows_the_area_ = false;  // since a loop was closed
};

}  // namespace mapbed
