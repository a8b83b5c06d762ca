#include "algorithms/people/front_end/people_front_end.h"

#include <utility>

namespace mapbed {

void find_sightings(ScanSightings& scan, const RecentScans& before,
                    const PeopleFrontEndOptions& options) {
  scan.places.clear();
  for (const LegFeature& feature : scan.features) {
    scan.places.push_back(before.before(feature, scan.local_from_robot, options.features.radius));
  }
  scan.past = before.past(scan.time());
  scan.sightings =
      sightings_of(scan.features, scan.places, scan.past, scan.local_from_robot, options.sightings);
}

ScanSightings mirrored_in_time(const KeptScan& scan) {
  LaserScan readings = scan.readings;
  readings.time = -readings.time;
  return {ScanView(std::move(readings)), scan.local_from_robot, {}, {}, {}, {}};
}

ScanSightings PeopleFrontEnd::add(const LaserScan& scan, std::span<const float> beam_weights) {
  ScanSightings result{ScanView(scan), frame_.add(scan, beam_weights), {}, {}, {}, {}};
  result.features = leg_features(result.view, options_.features);
  find_sightings(result, recent_, options_);
  return result;
}

void PeopleFrontEnd::remember(const ScanSightings& scan, std::vector<bool> on_people) {
  recent_.add(scan.view, scan.local_from_robot, std::move(on_people));
}

}  // namespace mapbed
