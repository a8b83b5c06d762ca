#include "core/log/sensor_log.h"

#include <algorithm>

namespace mapbed {

bool has_scans(const SensorLog& log) {
  return std::any_of(log.begin(), log.end(),
                     [](const Measurement& m) { return std::holds_alternative<LaserScan>(m); });
}

Trajectory odometry_of(const SensorLog& log) {
  Trajectory path;
  for (const Measurement& measurement : log) {
    const auto* reading = std::get_if<Odometry>(&measurement);
    if (reading != nullptr) path.push_back({reading->time, reading->odometry_from_robot});
  }
  return path;
}

}  // namespace mapbed
