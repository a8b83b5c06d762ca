#include "algorithms/scan_matching/local_scans.h"

#include <cmath>

#include <tbb/parallel_for.h>

namespace mapbed {

LocalScans::LocalScans(const LocalMapOptions& local_map, const LikelihoodFieldOptions& field,
                       double max_range)
    : options_(local_map), max_range_(max_range), means_(field.resolution), field_(field) {}

void LocalScans::remember(const LaserScan& scan, const Pose2& map_from_robot) {
  const bool far = poses_.empty() || is_far_enough(poses_.back(), map_from_robot, options_);
  if (!far || scan.ranges.empty()) return;
  poses_.push_back(map_from_robot);
  const std::size_t forgotten = select_local_scans(poses_, options_).back();
  const auto remember_surfaces = [&] {
    points_.push_back(transformed(
        surface_points(scan, max_range_, options_.max_gap, field_.resolution()), map_from_robot));
    means_.add(points_.back());
    forget_surfaces(forgotten);
  };
  const auto remember_ground = [&] {
    outlines_.push_back(ObservedGround::outline_of(scan, max_range_, map_from_robot));
    ground_.add(outlines_.back());
    forget_ground(forgotten);
  };
  tbb::parallel_for(std::size_t{0}, std::size_t{2},
                    [&](std::size_t i) { i == 0 ? remember_surfaces() : remember_ground(); });
  forget_poses(forgotten);
}

void LocalScans::forget_past(bool keep_newest) {
  const std::size_t kept = keep_newest ? 1 : 0;
  if (poses_.size() > kept) forget_oldest(poses_.size() - kept);
}

void LocalScans::forget_oldest(std::size_t count) {
  forget_surfaces(count);
  forget_ground(count);
  forget_poses(count);
}

void LocalScans::forget_surfaces(std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    means_.remove(points_.front());
    points_.pop_front();
  }
  field_.update(means_, means_.take_changed());
  pyramid_is_current_ = false;
  icp_map_.reset();
}

void LocalScans::forget_ground(std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    ground_.remove(outlines_.front());
    outlines_.pop_front();
  }
}

void LocalScans::forget_poses(std::size_t count) {
  poses_.erase(poses_.begin(), poses_.begin() + static_cast<std::ptrdiff_t>(count));
}

std::vector<bool> LocalScans::known(const std::vector<Eigen::Vector2d>& hits,
                                    const Pose2& robot_from_laser, const Pose2& predicted) const {
  const Eigen::Vector2d laser = (predicted * robot_from_laser).position();
  const double c = std::cos(predicted.theta), s = std::sin(predicted.theta);
  std::vector<bool> result;
  result.reserve(hits.size());
  for (const Eigen::Vector2d& hit : hits) {
    result.push_back(ground_.knows_about(
        {predicted.x + c * hit.x() - s * hit.y(), predicted.y + s * hit.x() + c * hit.y()}, laser,
        field_));
  }
  return result;
}

const BoundPyramid& LocalScans::pyramid(double window) {
  if (!pyramid_is_current_) remake_bound_pyramid(field_, window, pyramid_);
  pyramid_is_current_ = true;
  return pyramid_;
}

const IcpMap& LocalScans::icp_map() {
  if (!icp_map_) icp_map_.emplace(means_.means());
  return *icp_map_;
}

}  // namespace mapbed
