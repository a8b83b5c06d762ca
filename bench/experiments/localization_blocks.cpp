#include "bench/experiments/localization_blocks.h"

#include <algorithm>
#include <cmath>

#include "algorithms/grid/wall_map.h"
#include "algorithms/scan/scans_on_path.h"

namespace mapbed {
namespace {

bool is_near_any(const Pose2& pose, const std::vector<Pose2>& others, double near) {
  return std::any_of(others.begin(), others.end(),
                     [&](const Pose2& other) { return distance(pose, other) <= near; });
}

bool is_lost(const Estimate& estimate, double time) {
  return std::any_of(estimate.lost.begin(), estimate.lost.end(), [time](const TimeInterval& lost) {
    return time >= lost.from && time <= lost.to;
  });
}

}  // namespace

DriveBlocks blocks_of(const SensorLog& log, const Trajectory& map_from_robot, double seconds,
                      double near, const MapOptions& options) {
  DriveBlocks result;
  if (log.empty()) return result;
  const double start = time_of(log.front());
  const auto number_of = [&](double time) {
    return static_cast<std::size_t>((time - start) / seconds);
  };
  SensorLog mapped;
  Trajectory mapped_path;
  const auto block_at = [&](double time) -> DriveBlocks::Block& {
    const std::size_t number = number_of(time) / 2;
    if (result.blocks.size() <= number) result.blocks.resize(number + 1);
    return result.blocks[number];
  };
  const auto is_mapped = [&](double time) { return number_of(time) % 2 == 0; };
  for_each_scan_on_path(log, map_from_robot, [&](const LaserScan& scan, const Pose2& pose) {
    if (is_mapped(scan.time)) {
      mapped.push_back(scan);
      mapped_path.push_back({scan.time, pose});
      result.mapped_from.push_back(pose);
    } else {
      block_at(scan.time).truth.push_back({scan.time, pose});
    }
  });
  for (const Measurement& measurement : log) {
    const double time = time_of(measurement);
    if (!is_mapped(time)) block_at(time).log.push_back(measurement);
  }
  std::erase_if(result.blocks, [](const auto& block) { return block.truth.size() < 2; });
  for (DriveBlocks::Block& block : result.blocks) {
    block.is_near_map = std::all_of(block.truth.begin(), block.truth.end(), [&](const auto& at) {
      return is_near_any(at.pose, result.mapped_from, near);
    });
  }
  result.map = std::make_shared<OccupancyMap>(wall_map(mapped, mapped_path, options));
  return result;
}

BlockResult judged(const Estimate& estimate, const Trajectory& truth, double limit) {
  BlockResult result;
  double found = HUGE_VAL;
  for (const Stamped<Pose2>& stamped : estimate.trajectory) {
    const std::optional<Pose2> true_pose = pose_at(truth, stamped.time);
    if (!true_pose) continue;
    const double error = distance(stamped.pose, *true_pose);
    const bool is_wrong = !(error <= limit);
    const bool is_known = !is_lost(estimate, stamped.time);
    ++result.scans;
    if (!is_known) ++result.unknown;
    if (is_known) result.errors.push_back(error);
    if (is_wrong) ++result.off;
    if (is_wrong && is_known) ++result.wrongly_known;
    if (is_wrong || !is_known) {
      found = HUGE_VAL;
    } else {
      found = std::min(found, stamped.time);
    }
  }
  result.is_found = std::isfinite(found);
  result.seconds_to_it = result.is_found ? found - truth.front().time : NAN;
  return result;
}

}  // namespace mapbed
