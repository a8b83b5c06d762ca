#include "algorithms/field/local_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/check.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

constexpr double kStepsPerUnit = 1 << 24;  // of SurfaceMeans' sums, in a metre

}  // namespace

bool is_far_enough(const Pose2& integrated, const Pose2& pose, const LocalMapOptions& options) {
  return distance(integrated, pose) >= options.min_distance ||
         std::abs(angle_difference(integrated.theta, pose.theta)) >= options.min_turn;
}

std::vector<std::size_t> select_local_scans(const std::vector<Pose2>& poses,
                                            const LocalMapOptions& options) {
  CHECK(options.max_scans > 0 && options.max_history > 0);
  std::vector<std::size_t> selected;
  if (poses.empty()) return selected;
  const std::size_t t = poses.size();  // the scan to be matched; the newest past one is t - 1
  selected.push_back(t - 1);
  for (std::size_t i = t - 1; i-- > 0;) {
    const bool enough = selected.size() >= static_cast<std::size_t>(options.max_scans) ||
                        t - i >= static_cast<std::size_t>(options.max_history);
    if (enough) break;
    if (is_far_enough(poses[selected.back()], poses[i], options)) selected.push_back(i);
  }
  return selected;
}

SurfaceMeans::Cell& SurfaceMeans::cell_for_writing(CellIndex index) {
  std::uint32_t& slot = slots_.at(index);
  if (slot == kNotHit) {
    hit_cells_.push_back(index);
    if (free_slots_.empty()) {
      slot = static_cast<std::uint32_t>(cells_.size());
      cells_.emplace_back();
    } else {
      slot = free_slots_.back();
      free_slots_.pop_back();
    }
  }
  return cells_[slot];
}

void SurfaceMeans::release(CellIndex index) {
  std::uint32_t& slot = slots_.at(index);
  cells_[slot] = Cell{};
  free_slots_.push_back(std::exchange(slot, kNotHit));
}

void SurfaceMeans::count(const SurfacePoint& point, int sign) {
  const CellIndex index = slots_.cell_of(point.position);
  Cell& cell = cell_for_writing(index);
  const auto steps = [&](double value) { return sign * std::llround(value * kStepsPerUnit); };
  cell.x += steps(point.position.x());
  cell.y += steps(point.position.y());
  cell.doubled_x += steps(point.doubled.x());
  cell.doubled_y += steps(point.doubled.y());
  cell.count += sign;
  if (!cell.changed) changed_cells_.push_back(index);
  cell.changed = true;
}

void SurfaceMeans::add(const std::vector<SurfacePoint>& points_in_map) {
  for (const SurfacePoint& point : points_in_map) count(point, 1);
}

void SurfaceMeans::remove(const std::vector<SurfacePoint>& points_in_map) {
  for (const SurfacePoint& point : points_in_map) count(point, -1);
  std::erase_if(hit_cells_, [&](const CellIndex index) {
    const int count = cells_[slots_[index]].count;
    CHECK(count >= 0);
    if (count == 0) release(index);
    return count == 0;
  });
}

void SurfaceMeans::clear() {
  for (const CellIndex index : hit_cells_) {
    if (!cells_[slots_[index]].changed) changed_cells_.push_back(index);
    release(index);
  }
  hit_cells_.clear();
}

std::vector<CellIndex> SurfaceMeans::take_changed() {
  for (const CellIndex index : changed_cells_) cells_[slots_[index]].changed = false;
  return std::exchange(changed_cells_, {});
}

SurfacePoint SurfaceMeans::mean_of(const Cell& cell) {
  const double scale = 1.0 / (kStepsPerUnit * cell.count);
  const auto mean = [&](std::int64_t x, std::int64_t y) -> Eigen::Vector2d {
    return scale * Eigen::Vector2d(static_cast<double>(x), static_cast<double>(y));
  };
  return {mean(cell.x, cell.y), mean(cell.doubled_x, cell.doubled_y)};
}

std::optional<SurfacePoint> SurfaceMeans::mean_in(CellIndex index) const {
  const std::uint32_t slot = slots_[index];
  if (slot == kNotHit) return std::nullopt;
  return mean_of(cells_[slot]);
}

std::vector<SurfacePoint> SurfaceMeans::means() const {
  std::vector<SurfacePoint> result;
  result.reserve(hit_cells_.size());
  for (const CellIndex index : hit_cells_) result.push_back(mean_of(cells_[slots_[index]]));
  return result;
}

}  // namespace mapbed
