#include "bench/film/course.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "algorithms/estimator.h"
#include "bench/sources/run_input.h"
#include "sim/recording.h"

namespace mapbed {
namespace {

// A scan is put into the map where the robot has moved since the last one that was: more of one
// place show nothing new but behind those who have moved on, and all of them move when the path
// does.
constexpr double kMapDistance = 0.2;  // [m]
constexpr double kMapTurn = 0.1;      // [rad]
constexpr double kMapSeconds = 5.0;   // after which one of the same place is put in, too

constexpr float kBranchStep = 0.2F;          // [m] between points of a branch
constexpr std::size_t kBranchPoints = 4000;  // of all branches of a step

bool has_moved(const Pose2& from, const Pose2& to) {
  return distance(from, to) >= kMapDistance ||
         std::abs(std::remainder(to.theta - from.theta, 2.0 * M_PI)) >= kMapTurn;
}

std::vector<Eigen::Vector2f> newest_part(const Trajectory& branch, std::size_t most) {
  std::vector<Eigen::Vector2f> part;
  for (auto at = branch.rbegin(); at != branch.rend() && part.size() < most; ++at) {
    const Eigen::Vector2f place = at->pose.position().cast<float>();
    if (part.empty() || (place - part.back()).norm() >= kBranchStep) part.push_back(place);
  }
  return part;
}

// Particles stand at the last update; the best of them tells how the robot has moved since.
Pose2 moved_on(const Stamped<Pose2>& particle, const Trajectory& path) {
  const auto then =
      std::lower_bound(path.begin(), path.end(), particle.time,
                       [](const auto& pose, double time) { return pose.time < time; });
  if (then == path.end() || then->time != particle.time) return particle.pose;
  return particle.pose * motion_between(then->pose, path.back().pose);
}

}  // namespace

CourseRecorder::CourseRecorder(Choose choose, Tell tell, GoesOn goes_on)
    : choose_(std::move(choose)), tell_(std::move(tell)), goes_on_(std::move(goes_on)) {}

void CourseRecorder::begins(const RunInput& prepared, const std::string& method) {
  input_ = &prepared;
  course_ = {.method = method, .truth = prepared.truth};
  if (!prepared.log.empty()) {
    course_.start = time_of(prepared.log.front());
    course_.end = time_of(prepared.log.back());
  }
  moments_ = choose_(course_.end - course_.start);
  next_ = course_.start + moments_.from;
  if (prepared.world != nullptr) course_.outlines = outlines_of(*prepared.world);
  if (prepared.recording != nullptr) {
    course_.others = replay_of(prepared.recording->truth, {}).others;
  }
}

void CourseRecorder::after(const Measurement& measurement, const Estimator& estimator) {
  throw_unless(goes_on_);
  const auto* scan = std::get_if<LaserScan>(&measurement);
  if (scan == nullptr || !scan->robot_from_laser.is_level()) return;
  take_scan(*scan, estimator.pose());
  if (scan->time < next_) return;
  look(*scan, estimator);
  tell_(scan->time - course_.start);
  if (scan->time >= course_.start + moments_.to) {
    tell_what_moves(estimator.estimate());
    is_complete_ = true;
    throw Interrupted();
  }
}

void CourseRecorder::take_scan(const LaserScan& scan, const Pose2& map_from_robot) {
  const std::size_t number = taken_++;
  const bool is_of_same_place = of_newest_map_scan_ &&
                                scan.time < of_newest_map_scan_->time + kMapSeconds &&
                                !has_moved(of_newest_map_scan_->pose, map_from_robot);
  if (is_of_same_place) return;
  of_newest_map_scan_ = {scan.time, map_from_robot};
  course_.scans[number] = scan;
  course_.of_map.push_back(number);
}

void CourseRecorder::look(const LaserScan& scan, const Estimator& estimator) {
  const Trajectory path = estimator.path_so_far();
  // Of a method that does not yet say where it was.
  if (path.size() != taken_ || path.back().time != scan.time) return;
  CourseStep step{.time = scan.time};
  tell_path(path, step);
  const Hypotheses held = estimator.hypotheses();
  for (const Trajectory& branch : held.branches) {
    step.particles.push_back(moved_on(branch.back(), path));
    step.branches.push_back(newest_part(branch, kBranchPoints / held.branches.size() + 2));
  }
  course_.scans[taken_ - 1] = scan;
  course_.steps.push_back(std::move(step));
  while (next_ <= scan.time) next_ += std::max(moments_.step, 1e-3);
}

void CourseRecorder::align(const Stamped<Pose2>& first) {
  if (is_aligned_) return;
  is_aligned_ = true;
  const std::optional<Pose2> world_from_robot = pose_at(course_.truth, first.time);
  if (world_from_robot) {
    course_.world_from_map = *world_from_robot * inverse(first.pose);
  } else {
    course_.truth.clear();  // of another time
  }
}

// What differs from the path of the step before.
void CourseRecorder::tell_path(const Trajectory& path, CourseStep& step) {
  align(path.front());
  const std::size_t both = std::min(path.size(), path_.size());
  while (step.kept < both && path[step.kept].pose == path_[step.kept]) ++step.kept;
  for (std::size_t i = step.kept; i < path.size(); ++i) step.later.push_back(path[i].pose);
  path_.resize(step.kept);
  path_.insert(path_.end(), step.later.begin(), step.later.end());
}

void CourseRecorder::ends(const Estimate& estimate) {
  if (course_.steps.empty()) replay(estimate);
  if (estimate.trajectory.size() == taken_ && taken_ > 0) {
    CourseStep last{.time = estimate.trajectory.back().time};
    tell_path(estimate.trajectory, last);
    course_.last = std::move(last);
  }
  tell_what_moves(estimate);
  is_complete_ = true;
}

void CourseRecorder::tell_what_moves(const Estimate& estimate) {
  if (estimate.labels && estimate.labels->size() == taken_) {
    for (const auto& [number, scan] : course_.scans) {
      course_.labels[number] = (*estimate.labels)[number];
    }
  }
  if (estimate.tracks) course_.tracks = transformed(*estimate.tracks, course_.world_from_map);
}

// Its path in the end, from scan to scan.
void CourseRecorder::replay(const Estimate& estimate) {
  course_.scans.clear();
  course_.of_map.clear();
  of_newest_map_scan_.reset();
  taken_ = 0;
  path_.clear();
  next_ = course_.start + moments_.from;
  Trajectory path;
  auto pose = estimate.trajectory.begin();
  for (const Measurement& measurement : input_->log) {
    const auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr || !scan->robot_from_laser.is_level()) continue;
    while (pose != estimate.trajectory.end() && pose->time < scan->time) ++pose;
    if (pose == estimate.trajectory.end()) break;
    if (pose->time != scan->time) continue;
    take_scan(*scan, pose->pose);
    path.push_back(*pose);
    if (scan->time < next_) continue;
    CourseStep step{.time = scan->time};
    tell_path(path, step);
    course_.scans[taken_ - 1] = *scan;
    course_.steps.push_back(std::move(step));
    while (next_ <= scan->time) next_ += std::max(moments_.step, 1e-3);
    if (scan->time >= course_.start + moments_.to) break;
  }
}

}  // namespace mapbed
