#pragma once

#include <span>
#include <vector>

#include "algorithms/people/front_end/leg_features.h"
#include "algorithms/people/front_end/local_frame.h"
#include "algorithms/people/front_end/moved_features.h"
#include "algorithms/people/front_end/scan_sightings.h"
#include "algorithms/people/front_end/sightings.h"
#include "core/config/option.h"
#include "core/sensor/laser_scan.h"
#include "core/sensor/odometry.h"

namespace mapbed {

struct PeopleFrontEndOptions {
  LegFeatureOptions features;
  RecentScansOptions recent;
  SightingOptions sightings;
};

template <class Visitor>
void visit_fields(PeopleFrontEndOptions& o, Visitor&& visit) {
  visit("features", o.features, "what looks like a leg");
  visit("recent", o.recent, "past scans, which show what moved");
  visit("sightings", o.sightings, "legs of one person");
}

// What moved of the scan's features, by scans before it, and which are of one person.
void find_sightings(ScanSightings& scan, const RecentScans& before,
                    const PeopleFrontEndOptions& options);

// The scan at the opposite time, for a tracker that follows people back.
ScanSightings mirrored_in_time(const KeptScan& scan);

// From scans to what may be people, the same for every tracker: leg features, whether they moved,
// pairs of legs, in a local frame that follows the robot by scan matching.
class PeopleFrontEnd {
 public:
  explicit PeopleFrontEnd(const PeopleFrontEndOptions& options) : options_(options) {}

  void add(const Odometry& reading) { frame_.add(reading); }

  // local_from_robot of the scan that comes next: by odometry, or as the robot moved before.
  Pose2 predicted(double time) const { return frame_.predicted(time); }

  // `beam_weights` are for the alignment, (3.11); empty: all count fully.
  ScanSightings add(const LaserScan& scan, std::span<const float> beam_weights);

  // The newest scan as one of the past, once it is known which of its beams met people.
  void remember(const ScanSightings& scan, std::vector<bool> on_people);

 private:
  PeopleFrontEndOptions options_;
  LocalFrame frame_;
  RecentScans recent_{options_.recent};
};

}  // namespace mapbed
