#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include <Eigen/Core>

#include "algorithms/people/front_end/leg_features.h"
#include "algorithms/people/front_end/scan_view.h"
#include "core/config/option.h"
#include "core/geometry/pose2.h"

namespace mapbed {

// What scans of the last seconds saw at the place of a feature.
enum class SeenBefore {
  nothing,  // they did not see the place, or not often enough
  free,     // they saw through it: what stands there now came from elsewhere
  mixed,    // both, at different times: glass, or somebody who walks to and fro
  same,     // something stood there already
};

using ScanBits = std::uint64_t;  // one for each past scan that is compared with, the oldest first

// What each of them saw at a place.
struct PlaceBefore {
  ScanBits free = 0;
  ScanBits same = 0;
  bool rides_along = false;  // with the robot, as a part of it
};

// The past scans themselves.
struct PastScans {
  std::vector<double> times;  // [s]
  ScanBits old = 0;           // longer ago than somebody who walks stays where he is
  int least_free = 2;

  // Without what the scans of some bits say. What rides along with the robot was there before too.
  SeenBefore verdict(const PlaceBefore& place, ScanBits without = 0) const;
};

// What a scan sees at a point of its robot's frame where a thing of `radius` [m] may stand, up to
// `aside` [m] to the left or right: `same` where a beam ends within `tolerance` [m] of it, `free`
// where one passes that would have met it and none ends before. Beams of `on_people` (may be empty)
// say nothing.
SeenBefore seen_at(const ScanView& view, const Eigen::Vector2d& point_in_robot, double radius,
                   double aside, double tolerance, const std::vector<bool>& on_people = {});

// The same where something was seen before, to see whether it left.
SeenBefore seen_again_at(const ScanView& view, const Eigen::Vector2d& point_in_robot);

struct RecentScansOptions {
  int scans = 12;
  double spacing = 0.4;    // [s]
  double tolerance = 0.2;  // [m]
  int least_free = 2;
  double lasting = 1.2;  // [s]
};

template <class Visitor>
void visit_fields(RecentScansOptions& o, Visitor&& visit) {
  visit("scans", o.scans, between(1, 64), "of the past that are compared with");
  visit("spacing", o.spacing, Unit::second, between(0.0, 60.0), "between two of them at least");
  visit("tolerance", o.tolerance, Unit::meter, between(0.01, 2.0),
        "of a range; a beam saw through a place if it ended farther behind it");
  visit("least_free", o.least_free, between(1, 1000),
        "scans that saw through the place of a feature that moved");
  visit("lasting", o.lasting, Unit::second, between(0.0, 600.0),
        "ago, before which a scan that saw something there tells that it may not have moved: glass "
        "is seen at times and seen through at others");
}

// The difference of consecutive, scan-matched local grids (Figure 3.2), looked up at features: a
// grid of what a scan saw is as well read from the scan itself, to the exactness of its beams.
class RecentScans {
 public:
  explicit RecentScans(const RecentScansOptions& options) : options_(options) {}

  // Beams of people that are followed say nothing about the place: who stops stays a person.
  void add(ScanView view, const Pose2& local_from_robot, std::vector<bool> on_people);

  // Of a feature of the scan that comes next. What stays where it is in the robot's frame while
  // that moves is a part of the robot.
  PlaceBefore before(const LegFeature& feature, const Pose2& local_from_robot, double radius) const;
  // The same of any point of the robot's frame, where neighbouring beams are `spacing` [m] apart.
  PlaceBefore before(const Eigen::Vector2d& point_in_robot, double spacing,
                     const Pose2& local_from_robot, double radius) const;
  PastScans past(double now) const;

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
