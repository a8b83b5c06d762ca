#include "algorithms/people/people_front_end.h"

#include <utility>

#include "algorithms/scan/beam_weights.h"

namespace mapbed {

void find_sightings(ScanSightings& scan, const RecentScans& before,
                    const PeopleFrontEndOptions& options) {
  scan.before.clear();
  for (const LegFeature& feature : scan.features) {
    scan.before.push_back(
        before.seen_before(feature, scan.time(), scan.local_from_robot, options.features.radius));
  }
  scan.sightings =
      sightings_of(scan.features, scan.before, scan.local_from_robot, options.sightings);
}

ScanSightings mirrored_in_time(const ScanSightings& scan) {
  LaserScan readings = scan.view.scan();
  readings.time = -readings.time;
  return {ScanView(std::move(readings)), scan.local_from_robot, scan.features, {}, {}};
}

void PeopleFrontEnd::add(const Odometry& reading) {
  odometry_.add(reading);
  matcher_.add(reading);
}

Pose2 PeopleFrontEnd::predicted(double time) const {
  const Pose2 last = matcher_.pose();
  if (!last_time_) return last;
  const std::optional<Pose2> odometry = odometry_.at(time);
  if (odometry && odometry_at_last_scan_) {
    return last * motion_between(*odometry_at_last_scan_, *odometry);
  }
  const double seconds = time - *last_time_;
  const bool goes_on = last_seconds_ > 0.0 && seconds > 0.0 && seconds < 2.0 * last_seconds_;
  return goes_on ? last * interpolate({}, last_motion_, seconds / last_seconds_) : last;
}

ScanSightings PeopleFrontEnd::add(const LaserScan& scan, std::span<const float> beam_weights) {
  const Pose2 before = matcher_.pose();
  matcher_.add(scan, beam_weights);
  if (last_time_) {
    last_motion_ = motion_between(before, matcher_.pose());
    last_seconds_ = scan.time - *last_time_;
  }
  last_time_ = scan.time;
  odometry_at_last_scan_ = odometry_.at(scan.time);

  ScanSightings result{ScanView(scan), matcher_.pose(), {}, {}, {}};
  result.features = leg_features(result.view, options_.features);
  find_sightings(result, recent_, options_);
  return result;
}

void PeopleFrontEnd::remember(const ScanSightings& scan, std::vector<bool> on_people) {
  recent_.add(scan.view, scan.local_from_robot, std::move(on_people));
}

}  // namespace mapbed
