#include "bench/faults/restart.h"

#include <optional>

#include "bench/faults/fault_instants.h"

namespace mapbed {
namespace {

constexpr double kSeconds = 2.0;  // in which the robot moves when its odometry restarts

}  // namespace

BrokenLog with_restart(SensorLog log, const RestartOptions& options, Rng rng) {
  if (!options.enabled) return {std::move(log)};
  BrokenLog broken{std::move(log)};
  for (const double at : fault_instants(broken.log, options.at, kSeconds, rng)) {
    double before = at;  // [s] stamp of the last reading that counts on
    std::optional<Pose2> zero_from_odometry;
    for (Measurement& measurement : broken.log) {
      auto* reading = std::get_if<Odometry>(&measurement);
      if (reading == nullptr) continue;
      if (reading->time <= at) {
        before = reading->time;
        continue;
      }
      if (!zero_from_odometry) {
        zero_from_odometry = inverse(reading->odometry_from_robot);
        broken.when.push_back({before, reading->time});
        reading->odometry_from_robot = {};
      } else {
        reading->odometry_from_robot = *zero_from_odometry * reading->odometry_from_robot;
      }
    }
  }
  return broken;
}

}  // namespace mapbed
