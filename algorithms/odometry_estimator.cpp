#include "algorithms/odometry_estimator.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/check.h"

namespace mapbed {
namespace {

// The reading at a time, interpolated; the outermost one outside. Not for an empty list.
Pose2 held_at(const Trajectory& odometry, double time) {
  if (time <= odometry.front().time) return odometry.front().pose;
  if (time >= odometry.back().time) return odometry.back().pose;
  return *pose_at(odometry, time);
}

// Time to the nearer of the readings before and after [s].
double distance_in_time(const Trajectory& odometry, double time) {
  const auto after =
      std::lower_bound(odometry.begin(), odometry.end(), time,
                       [](const Stamped<Pose2>& reading, double t) { return reading.time < t; });
  const double ahead = after == odometry.end() ? HUGE_VAL : after->time - time;
  const double behind = after == odometry.begin() ? HUGE_VAL : time - (after - 1)->time;
  return std::min(ahead, behind);
}

// "no odometry from 12.3 s to 22.4 s", for every run of scans without a reading beside them.
std::vector<Remark> remarks_on(const std::vector<double>& stamps, const Trajectory& odometry,
                               double longest_gap) {
  const auto is_far = [&](double t) { return distance_in_time(odometry, t) > longest_gap; };
  std::vector<Remark> remarks;
  for (auto from = stamps.begin();;) {
    from = std::find_if(from, stamps.end(), is_far);
    if (from == stamps.end()) return remarks;
    const auto end = std::find_if_not(from, stamps.end(), is_far);
    remarks.push_back({RemarkKind::no_odometry,
                       fmt::format("no odometry beside {} scans from {:.3f} s to {:.3f} s",
                                   end - from, *from, *(end - 1)),
                       TimeInterval{*from, *(end - 1)}});
    from = end;
  }
}

}  // namespace

void OdometryEstimator::add(const Measurement& measurement, std::span<const float>) {
  if (const auto* reading = std::get_if<Odometry>(&measurement)) {
    CHECK(odometry_.empty() || reading->time >= odometry_.back().time);
    odometry_.push_back({reading->time, reading->odometry_from_robot});
  } else if (const auto* scan = std::get_if<LaserScan>(&measurement)) {
    if (lasers_.take(*scan)) scan_stamps_.push_back(scan->time);
  }
}

Pose2 OdometryEstimator::pose() const {
  if (odometry_.empty() || scan_stamps_.empty()) return start_;
  return start_ * motion_between(held_at(odometry_, scan_stamps_.front()), odometry_.back().pose);
}

Estimate OdometryEstimator::estimate() const {
  Estimate result{.remarks = lasers_.remarks()};
  if (scan_stamps_.empty()) return result;
  if (odometry_.empty()) {
    for (const double time : scan_stamps_) result.trajectory.push_back({time, start_});
    result.untrusted_scans = static_cast<int>(scan_stamps_.size());
    const Remark all_stand{RemarkKind::no_odometry,
                           "no odometry at all: every pose is the first one"};
    result.remarks.push_back(all_stand);
    return result;
  }
  const Pose2 map_from_odometry = start_ * inverse(held_at(odometry_, scan_stamps_.front()));
  for (const double time : scan_stamps_) {
    result.trajectory.push_back({time, map_from_odometry * held_at(odometry_, time)});
    if (time < odometry_.front().time || time > odometry_.back().time) ++result.untrusted_scans;
  }
  for (Remark& remark : remarks_on(scan_stamps_, odometry_, options_.longest_gap)) {
    result.remarks.push_back(std::move(remark));
  }
  return result;
}

}  // namespace mapbed
