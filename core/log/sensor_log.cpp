#include "core/log/sensor_log.h"

namespace mapbed {

Trajectory odometry_of(const SensorLog& log) {
  Trajectory path;
  for (const Measurement& measurement : log) {
    const auto* reading = std::get_if<Odometry>(&measurement);
    if (reading != nullptr) path.push_back({reading->time, reading->odometry_from_robot});
  }
  return path;
}

}  // namespace mapbed
