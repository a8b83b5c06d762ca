#pragma once

#include <deque>
#include <vector>

#include <Eigen/Core>

#include "algorithms/people/leg_features.h"
#include "algorithms/people/scan_view.h"
#include "core/config/option.h"
#include "core/geometry/pose2.h"

namespace mapbed {

// What scans of the last seconds saw at the place of a feature.
enum class SeenBefore {
  nothing,  // they did not see the place, or not often enough
  free,     // they saw through it: what stands there now came from elsewhere
  same,     // something stood there already
};

// What a scan sees at a point of its robot's frame where a thing of `radius` [m] may stand, up to
// `aside` [m] to the left or right: `same` where a beam ends within `tolerance` [m] of it, `free`
// where one passes that would have met it and none ends before. Beams of `on_people` (may be empty)
// say nothing.
SeenBefore seen_at(const ScanView& view, const Eigen::Vector2d& point_in_robot, double radius,
                   double aside, double tolerance, const std::vector<bool>& on_people = {});

struct RecentScansOptions {
  int scans = 12;
  double spacing = 0.4;    // [s]
  double tolerance = 0.2;  // [m]
  int least_free = 2;
  double lasting = 1.2;  // [s]
};

template <class Visitor>
void visit_fields(RecentScansOptions& o, Visitor&& visit) {
  visit("scans", o.scans, between(1, 1000), "of the past that are compared with");
  visit("spacing", o.spacing, Unit::second, between(0.0, 60.0), "between two of them at least");
  visit("tolerance", o.tolerance, Unit::meter, between(0.01, 2.0),
        "of a range; a beam saw through a place if it ended farther behind it");
  visit("least_free", o.least_free, between(1, 1000),
        "scans that saw through the place of a feature that moved");
  visit("lasting", o.lasting, Unit::second, between(0.0, 600.0),
        "ago, in which a single scan that saw something there tells that it did not move: glass is "
        "seen at times and seen through at others");
}

// The difference of consecutive, scan-matched local grids (Figure 3.2), looked up at features: a
// grid of what a scan saw is as well read from the scan itself, to the exactness of its beams.
class RecentScans {
 public:
  explicit RecentScans(const RecentScansOptions& options) : options_(options) {}

  // Beams of people that are followed say nothing about the place: who stops stays a person.
  void add(ScanView view, const Pose2& local_from_robot, std::vector<bool> on_people);

  // A feature of the scan that comes next. What stays where it is in the robot's frame while that
  // moves is a part of the robot: it was there before too.
  SeenBefore seen_before(const LegFeature& feature, double now, const Pose2& local_from_robot,
                         double radius) const;
  // The same of any point of the robot's frame, where neighbouring beams are `spacing` [m] apart.
  SeenBefore seen_before(const Eigen::Vector2d& point_in_robot, double spacing, double now,
                         const Pose2& local_from_robot, double radius) const;

 private:
  struct Scan {
    ScanView view;
    Pose2 robot_from_local;
    std::vector<bool> on_people;
  };
  RecentScansOptions options_;
  std::deque<Scan> scans_;
};

}  // namespace mapbed
