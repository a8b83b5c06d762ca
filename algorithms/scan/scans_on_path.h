#pragma once

#include <variant>

#include "core/check.h"
#include "core/geometry/trajectory.h"
#include "core/log/sensor_log.h"

namespace mapbed {

// visit(scan, pose) for the scans of a log's level lasers and the poses of a path, one for each of
// them, in their order. A path that ends before the log ends it: of a log that was not read to its
// end.
template <class Visitor>
void for_each_scan_on_path(const SensorLog& log, const Trajectory& path, Visitor&& visit) {
  auto next = path.begin();
  for (const Measurement& measurement : log) {
    const auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr || !scan->robot_from_laser.is_level()) continue;
    if (next == path.end()) return;
    CHECK(next->time == scan->time);
    visit(*scan, next->pose);
    ++next;
  }
  CHECK(next == path.end());
}

}  // namespace mapbed
