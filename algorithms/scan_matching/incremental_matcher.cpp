#include "algorithms/scan_matching/incremental_matcher.h"

#include <algorithm>
#include <cmath>

#include "algorithms/scan/beam_weights.h"
#include "core/check.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

constexpr std::size_t kMinPoints = 10;  // fewer say nothing about a pose
constexpr double kClearlyMore = 0.1;    // of the scan explained

}  // namespace

IncrementalMatcher::IncrementalMatcher(const IncrementalMatcherOptions& options, const Pose2& start)
    : options_(options),
      map_from_robot_(start),
      means_(options.field.resolution),
      field_(options.field) {}

void IncrementalMatcher::add(const Measurement& measurement, std::span<const float> beam_weights) {
  if (const auto* odometry = std::get_if<Odometry>(&measurement)) odometry_.add(*odometry);
  const auto* scan = std::get_if<LaserScan>(&measurement);
  if (scan != nullptr && lasers_.take(*scan)) {
    add_scan(beam_weights.empty() ? *scan : with_failed_beams(*scan, beam_weights), beam_weights);
  }
}

Estimate IncrementalMatcher::estimate() const {
  return {.trajectory = trajectory_,
          .lost = {},
          .untrusted_scans = untrusted_scans_,
          .remarks = lasers_.remarks()};
}

std::optional<Pose2> IncrementalMatcher::odometry_at(double time) const {
  return options_.use_odometry ? odometry_.at(time) : std::optional<Pose2>{};
}

IncrementalMatcher::Prediction IncrementalMatcher::predicted(double time) const {
  const std::optional<Pose2> odometry = odometry_at(time);
  if (!odometry || !odometry_at_last_scan_) return {prediction(time), true};
  return {predict(map_from_robot_, motion_between(*odometry_at_last_scan_, *odometry),
                  options_.motion)};
}

ScanMatch IncrementalMatcher::match(const LaserScan& scan, std::span<const float> beam_weights) {
  if (trajectory_.empty()) return {.map_from_robot = map_from_robot_};
  const auto [prior, blind] = predicted(scan.time);
  ScanMatch match = aligned(hit_points(scan, options_.points),
                            hit_point_weights(scan, options_.points, beam_weights), prior, blind);
  if (!match.trustworthy) match.map_from_robot = prior.mean;
  return match;
}

void IncrementalMatcher::add_scan(const LaserScan& scan, std::span<const float> beam_weights) {
  if (!trajectory_.empty()) {
    CHECK(scan.time >= trajectory_.back().time);
    last_match_ = match(scan, beam_weights);
    map_from_robot_ = last_match_.map_from_robot;
    if (!last_match_.trustworthy) ++untrusted_scans_;
  }
  odometry_at_last_scan_ = odometry_at(scan.time);
  trajectory_.push_back({scan.time, map_from_robot_});
  remember(scan);
}

// Where the robot is if it went on as between the last two scans.
PosePrior IncrementalMatcher::prediction(double time) const {
  const Stamped<Pose2>& newest = trajectory_.back();
  const double seconds = time - newest.time;
  Pose2 motion;
  if (trajectory_.size() >= 2) {
    const Stamped<Pose2>& before = trajectory_[trajectory_.size() - 2];
    const double step = newest.time - before.time;
    if (step > 0.0 && seconds <= 2.0 * step) {
      motion = interpolate({}, motion_between(before.pose, newest.pose), seconds / step);
    }
  }
  return predict_blindly(newest.pose, motion, seconds, options_.motion);
}

ScanMatch IncrementalMatcher::aligned(const std::vector<Eigen::Vector2d>& points,
                                      const std::vector<float>& weights, const PosePrior& prior,
                                      bool blind) {
  if (points.size() < kMinPoints || kept_poses_.empty()) return {.map_from_robot = prior.mean};
  if (options_.alignment == Alignment::icp) {
    if (!icp_map_) icp_map_.emplace(means_.means());
    return match_icp(points, *icp_map_, prior, options_.icp, weights);
  }
  const FieldPoints in_cells = to_field_points(points, field_.resolution(), weights);
  ScanMatch match;
  if (options_.alignment == Alignment::hill_climbing) {
    match = match_scan(in_cells, field_, prior, options_.climb);
    const bool convincing = match.trustworthy && match.inlier_ratio >= options_.search_below;
    if (convincing && !blind) return match;
  }
  const Pose2 start =
      match_correlative(in_cells, field_, pyramid(), prior, options_.search).map_from_robot;
  const ScanMatch searched = match_scan_from(start, in_cells, field_, prior, options_.climb);
  // Beams err together, so a slightly better sum is no reason to leave the optimum next to where
  // odometry has the robot.
  const bool clearly =
      blind || !match.trustworthy || searched.inlier_ratio >= match.inlier_ratio + kClearlyMore;
  const bool better = searched.log_posterior > match.log_posterior && clearly;
  if (match.points_used == 0 || better) match = searched;
  return match.trustworthy ? match : searched_widely(in_cells, match);
}

// The best match of the wider search if it explains enough, else `match`.
ScanMatch IncrementalMatcher::searched_widely(const FieldPoints& points,
                                              const ScanMatch& match) const {
  const PosePrior anywhere{.mean = match.map_from_robot};
  const BoundPyramid wide = make_bound_pyramid(field_, options_.wide_search.window);
  const ScanMatch found = match_correlative(points, field_, wide, anywhere, options_.wide_search);
  ScanMatch refined =
      match_scan_from(found.map_from_robot, points, field_, anywhere, options_.climb);
  refined.contradicts_prediction = true;
  return refined.inlier_ratio >= options_.wide_search.min_inlier_ratio ? refined : match;
}

const BoundPyramid& IncrementalMatcher::pyramid() {
  if (!pyramid_is_current_) remake_bound_pyramid(field_, options_.search.window, pyramid_);
  pyramid_is_current_ = true;
  return pyramid_;
}

// Keeps the scan for the local map where it is far enough from the one kept before, and brings the
// local map up to date: as all kept scans are that far from each other, it is made of the newest of
// them. In between the map stays as it is: Algorithm 1 would only exchange its newest
// scan.
void IncrementalMatcher::remember(const LaserScan& scan) {
  const bool far =
      kept_poses_.empty() || is_far_enough(kept_poses_.back(), map_from_robot_, options_.local_map);
  if (!far) return;
  kept_poses_.push_back(map_from_robot_);
  kept_points_.push_back(
      transformed(surface_points(scan, options_.points.max_range, options_.local_map.max_gap,
                                 field_.resolution()),
                  map_from_robot_));

  means_.add(kept_points_.back());
  forget_oldest(select_local_scans(kept_poses_, options_.local_map).back());
}

void IncrementalMatcher::forget_past(bool keep_newest) {
  const std::size_t kept = keep_newest ? 1 : 0;
  if (kept_poses_.size() > kept) forget_oldest(kept_poses_.size() - kept);
}

void IncrementalMatcher::forget_oldest(std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    means_.remove(kept_points_.front());
    kept_points_.pop_front();
  }
  kept_poses_.erase(kept_poses_.begin(), kept_poses_.begin() + static_cast<std::ptrdiff_t>(count));
  field_.update(means_, means_.take_changed());
  pyramid_is_current_ = false;
  icp_map_.reset();
}

}  // namespace mapbed
