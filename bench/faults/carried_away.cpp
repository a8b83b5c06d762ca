#include "bench/faults/carried_away.h"

#include <optional>

#include "bench/faults/fault_instants.h"

namespace mapbed {
namespace {

bool is_within(double time, const TimeInterval& open) {
  return time > open.from && time < open.to;
}

// Odometry after the gap goes on from what it was before.
void join(SensorLog& log, const TimeInterval& gap) {
  std::optional<Pose2> before;
  std::optional<Pose2> told_from_odometry;
  for (Measurement& measurement : log) {
    auto* reading = std::get_if<Odometry>(&measurement);
    if (reading == nullptr) continue;
    Pose2& pose = reading->odometry_from_robot;
    if (reading->time <= gap.from) {
      before = pose;
    } else if (before) {
      if (!told_from_odometry) told_from_odometry = *before * inverse(pose);
      pose = *told_from_odometry * pose;
    }
  }
}

}  // namespace

BrokenLog with_carried_away(SensorLog log, const CarriedAwayOptions& options, Rng rng) {
  if (options.duration <= 0.0) return {std::move(log)};
  BrokenLog broken{std::move(log)};
  for (const double from : fault_instants(broken.log, options.at, options.duration, rng)) {
    const TimeInterval gap{from, from + options.duration};
    std::erase_if(broken.log, [&gap](const Measurement& m) { return is_within(time_of(m), gap); });
    join(broken.log, gap);
    broken.when.push_back(gap);
  }
  return broken;
}

}  // namespace mapbed
