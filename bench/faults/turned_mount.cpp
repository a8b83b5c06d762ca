#include "bench/faults/turned_mount.h"

#include "bench/faults/fault_instants.h"
#include "core/geometry/angle.h"

namespace mapbed {

BrokenLog with_turned_mount(SensorLog log, const TurnedMountOptions& options, Rng /*rng*/) {
  if (options.angle == 0.0 || log.empty()) return {std::move(log)};
  for (Measurement& measurement : log) {
    auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr) continue;
    double& heading = scan->robot_from_laser.planar.theta;
    heading = normalized_angle(heading + options.angle);
  }
  const TimeInterval whole = whole_of(log);
  return {std::move(log), {whole}};
}

}  // namespace mapbed
