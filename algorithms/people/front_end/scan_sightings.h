#pragma once

#include <vector>

#include "algorithms/people/front_end/leg_features.h"
#include "algorithms/people/front_end/scan_view.h"
#include "algorithms/people/front_end/sightings.h"
#include "core/geometry/pose2.h"

namespace mapbed {

// What is kept of a scan, to look at it again later: a view of it is more than twice as large.
struct KeptScan {
  LaserScan readings;
  Pose2 local_from_robot;

  double time() const { return readings.time; }
};

// What a tracker is given of one scan.
struct ScanSightings {
  ScanView view;
  Pose2 local_from_robot;
  std::vector<LegFeature> features;
  std::vector<PlaceBefore> places;  // of each feature
  PastScans past;                   // that these are by
  std::vector<Sighting> sightings;

  double time() const { return view.scan().time; }

  // What the scan sees at a place of the local frame.
  SeenBefore at(const Eigen::Vector2d& place) const {
    return seen_again_at(view, inverse(local_from_robot) * place);
  }
};

}  // namespace mapbed
