#include "bench/experiments/posed_scans.h"

#include <optional>

#include "core/input_error.h"

namespace mapbed {

PosedScans posed_scans(const RunInput& input, int count) {
  PosedScans result;
  for (const Measurement& measurement : input.log) {
    const auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr) continue;
    if (count > 0 && result.scans.size() == static_cast<std::size_t>(count)) break;
    const std::optional<Pose2> pose = pose_at(input.truth, scan->time);
    if (!pose) {
      throw InputError("the log has a scan whose true pose nobody knows; take a simulated log");
    }
    result.scans.push_back(*scan);
    result.world_from_robot.push_back({scan->time, *pose});
  }
  return result;
}

}  // namespace mapbed
