#include "algorithms/scan_matching/incremental_matcher.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Dense>

#include "algorithms/scan/beam_weights.h"
#include "algorithms/scan/footprint_weights.h"
#include "algorithms/scan_matching/match_covariance.h"
#include "core/check.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

constexpr std::size_t kMinPoints = 10;  // fewer say nothing about a pose
constexpr double kClearlyMore = 0.1;    // of the scan explained
constexpr double kAsMuch = 0.02;        // the same, up to the noise of beams

// Else all its beams failed.
bool is_measurement(const LaserScan& scan) {
  return std::any_of(scan.ranges.begin(), scan.ranges.end(),
                     [](double range) { return range > 0.0; });
}

// [m] of the position, in the worst direction.
std::optional<double> largest_sigma(const std::optional<MatchInformation>& match) {
  if (!match) return {};
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(
      Eigen::Matrix2d(match->covariance().topLeftCorner<2, 2>()));
  return std::sqrt(axes.eigenvalues().maxCoeff());
}

}  // namespace

IncrementalMatcher::IncrementalMatcher(const IncrementalMatcherOptions& options, const Pose2& start)
    : options_(options),
      map_from_robot_(start),
      recent_(options.motion),
      local_scans_(options.local_map, options.field, options.points.max_range) {}

void IncrementalMatcher::add(const Measurement& measurement, std::span<const float> beam_weights) {
  if (const auto* odometry = std::get_if<Odometry>(&measurement)) odometry_.add(*odometry);
  const auto* scan = std::get_if<LaserScan>(&measurement);
  if (scan != nullptr && lasers_.take(*scan)) {
    add_scan(beam_weights.empty() ? *scan : with_failed_beams(*scan, beam_weights), beam_weights);
  }
}

Estimate IncrementalMatcher::estimate() const {
  Estimate result{.trajectory = trajectory_,
                  .lost = diagnostics_.lost(),
                  .untrusted_scans = untrusted_scans_,
                  .remarks = lasers_.remarks()};
  if (trajectory_.empty()) return result;
  for (Remark& remark : diagnostics_.remarks(trajectory_.front().time)) {
    result.remarks.push_back(std::move(remark));
  }
  return result;
}

std::vector<Remark> IncrementalMatcher::remarks_on_unknown_motion() const {
  if (trajectory_.empty()) return {};
  return diagnostics_.remarks_on_unknown_motion(trajectory_.front().time);
}

std::optional<Pose2> IncrementalMatcher::odometry_at(double time) const {
  return options_.use_odometry ? odometry_.at(time) : std::optional<Pose2>{};
}

IncrementalMatcher::Prediction IncrementalMatcher::predicted(double time) const {
  const std::optional<Pose2> odometry = odometry_at(time);
  if (!odometry || !odometry_at_last_scan_) return {going_on(time), true};
  return {predict(map_from_robot_, motion_between(*odometry_at_last_scan_, *odometry),
                  time - trajectory_.back().time, learned_spread_.applied_to(options_.motion))};
}

// From the newest match, before the robot is taken to be there.
void IncrementalMatcher::learn_spread(double time) {
  const std::optional<Pose2> odometry = odometry_at(time);
  const bool was_near_prediction = last_match_.trustworthy && !last_match_.other_prediction &&
                                   !last_match_.contradicts_prediction;
  if (!odometry || !odometry_at_last_scan_ || !was_near_prediction) return;
  const Pose2 motion = motion_between(*odometry_at_last_scan_, *odometry);
  learned_spread_.add(motion, time - trajectory_.back().time,
                      motion_between(map_from_robot_ * motion, last_match_.map_from_robot),
                      options_.motion.odometry);
}

// Where the robot may be besides where odometry's last step ends: nowhere while scans and odometry
// agree about the last seconds and the scan fits there.
std::vector<IncrementalMatcher::OtherPrediction> IncrementalMatcher::other_predictions(
    double time, bool by_step_is_doubtful) const {
  const std::optional<Pose2> odometry = odometry_at(time);
  if (!odometry || !odometry_at_last_scan_) return {};
  const std::vector<PosePrior> late = recent_.elsewhere(time, *odometry);
  if (late.empty() && !by_step_is_doubtful) return {};
  const PosePrior going_on = this->going_on(time);
  const Pose2 step = map_from_robot_ * motion_between(*odometry_at_last_scan_, *odometry);
  std::vector<OtherPrediction> others;
  for (const PosePrior& prior : late) {
    others.push_back({prior, going_on.log_at(prior.mean) > going_on.log_at(step)});
  }
  const bool is_odd = std::any_of(others.begin(), others.end(),
                                  [](const OtherPrediction& other) { return other.is_likelier; });
  if (!is_odd && !by_step_is_doubtful) return {};
  others.push_back({going_on, false});
  const double seconds = time - trajectory_.back().time;
  others.push_back({predict_blindly(map_from_robot_, {}, seconds, options_.motion), false});
  return others;
}

ScanMatch IncrementalMatcher::match(const LaserScan& scan, std::span<const float> beam_weights) {
  if (trajectory_.empty()) return {.map_from_robot = map_from_robot_};
  const Hits hits = hits_of(scan, beam_weights);
  ScanMatch match = matched(hits, predicted(scan.time));
  const std::vector<OtherPrediction> others =
      other_predictions(scan.time, match.inlier_ratio < options_.search_below);
  if (!others.empty()) match = best_of(hits, match, others);
  return match;
}

IncrementalMatcher::Hits IncrementalMatcher::hits_of(const LaserScan& scan,
                                                     std::span<const float> beam_weights) const {
  const HitPointOptions& points = options_.points;
  Hits hits{hit_points(scan, points),
            hit_point_weights(scan, points, beam_weights),
            {},
            scan.robot_from_laser.planar};
  if (options_.weigh_footprints) {
    const std::vector<float> footprints =
        footprint_weights(scan, points.max_range, options_.local_map.max_gap, options_.field.sigma);
    hits.footprints = hit_point_weights(scan, points, footprints);
  }
  return hits;
}

// Beams err together, so that another place must explain clearly more of the scan than the one
// where odometry's last step has the robot; as much, where the step is the odd one.
ScanMatch IncrementalMatcher::best_of(const Hits& hits, const ScanMatch& by_step,
                                      const std::vector<OtherPrediction>& others) {
  const LikelihoodField& field = local_scans_.field();
  const FieldPoints all = to_field_points(hits.points, field.resolution(), hits.weights);
  const auto explained = [&](const ScanMatch& match) {
    return inlier_ratio(field.sum_log_at(all, match.map_from_robot),
                        double{field.outlier_log()} * all.total_weight());
  };
  ScanMatch best = by_step;
  const double by_step_explained = explained(by_step);
  double most = 0.0;
  for (const OtherPrediction& other : others) {
    ScanMatch match = matched_near(hits, {other.prior});
    const double share = explained(match);
    const double to_beat = by_step_explained + (other.is_likelier ? -kAsMuch : kClearlyMore);
    const bool convincing = match.trustworthy && match.inlier_ratio >= options_.search_below;
    if (!convincing || share < std::max(to_beat, most)) continue;
    match.other_prediction = other.prior.mean;
    best = match;
    most = share;
  }
  return best;
}

// Of the newest match by the scan alone.
std::optional<MatchInformation> IncrementalMatcher::information_by(const LaserScan& scan) const {
  const bool blind = !odometry_at(scan.time) || !odometry_at_last_scan_;
  if (!blind || !last_match_.trustworthy || !is_measurement(scan)) return {};
  const Pose2& pose = last_match_.map_from_robot;
  const FieldPoints points = known_points(hits_of(scan, {}), pose).climbed;
  return match_information(pose, points, local_scans_.field());
}

std::optional<Eigen::Matrix3d> IncrementalMatcher::blind_spread(int scans, double seconds) const {
  CHECK(scans > 0);
  if (!blind_information_) return {};
  const PosePrior from_scan_to_scan = predict_blindly({}, {}, seconds / scans, options_.motion);
  const Eigen::Matrix3d known =
      blind_information_->information() + from_scan_to_scan.information / scans;
  return Eigen::Matrix3d(known.inverse());
}

void IncrementalMatcher::add_scan(const LaserScan& scan, std::span<const float> beam_weights) {
  if (!trajectory_.empty()) {
    CHECK(scan.time >= trajectory_.back().time);
    last_match_ = match(scan, beam_weights);
    learn_spread(scan.time);
    map_from_robot_ = last_match_.map_from_robot;
    if (!last_match_.trustworthy) ++untrusted_scans_;
    blind_information_ = information_by(scan);
    if (is_measurement(scan)) {
      diagnostics_.scan(scan.time, last_match_, last_match_.points_used > 0,
                        largest_sigma(blind_information_));
    }
  }
  odometry_at_last_scan_ = odometry_at(scan.time);
  trajectory_.push_back({scan.time, map_from_robot_});
  if (odometry_at_last_scan_) {
    recent_.add(scan.time, map_from_robot_, *odometry_at_last_scan_);
  } else {
    recent_.clear();
  }
  local_scans_.remember(scan, map_from_robot_);
}

// Where the robot is if it went on as between the last two scans.
PosePrior IncrementalMatcher::going_on(double time) const {
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

// At the prediction where nothing there is to be trusted.
ScanMatch IncrementalMatcher::matched(const Hits& hits, const Prediction& prediction) {
  ScanMatch match = matched_near(hits, prediction);
  if (!match.trustworthy && match.points_used > 0 && options_.alignment != Alignment::icp) {
    match = searched_widely(hits, prediction, match);
  }
  if (!match.trustworthy) match.map_from_robot = prediction.prior.mean;
  return match;
}

ScanMatch IncrementalMatcher::matched_near(const Hits& hits, const Prediction& prediction) {
  const PosePrior& prior = prediction.prior;
  const ScanMatch none{.map_from_robot = prior.mean};
  if (hits.points.size() < kMinPoints || local_scans_.empty()) return none;
  if (options_.alignment == Alignment::icp) {
    return match_icp(hits.points, local_scans_.icp_map(), prior, options_.icp, hits.weights);
  }
  const KnownPoints points = known_points(hits, prior.mean);
  if (points.climbed.size() < kMinPoints) return none;
  const ScanMatch match = climbed(points, prediction);
  if (!match.trustworthy || points.climbed.size() == hits.points.size()) return match;
  return finer_across(match, points_on_lines(hits, match.map_from_robot).climbed,
                      local_scans_.field(), prior, options_.climb);
}

// Uphill from the prediction, and from the best place of a search where that does not convince.
ScanMatch IncrementalMatcher::climbed(const KnownPoints& known, const Prediction& prediction) {
  const PosePrior& prior = prediction.prior;
  const LikelihoodField& field = local_scans_.field();
  const FieldPoints& points = known.climbed;
  ScanMatch match;
  if (options_.alignment == Alignment::hill_climbing) {
    match = match_scan(points, field, prior, options_.climb);
    const bool convincing = match.trustworthy && match.inlier_ratio >= options_.search_below;
    if (convincing && !prediction.blind) return match;
  }
  const Pose2 start =
      match_correlative(known.searched(), field, local_scans_.pyramid(options_.search.window),
                        prior, options_.search)
          .map_from_robot;
  const ScanMatch searched = match_scan_from(start, points, field, prior, options_.climb);
  // Beams err together, so a slightly better sum is no reason to leave the optimum next to where
  // odometry has the robot.
  const bool clearly = prediction.blind || !match.trustworthy ||
                       searched.inlier_ratio >= match.inlier_ratio + kClearlyMore;
  const bool better = searched.log_posterior > match.log_posterior && clearly;
  if (match.points_used == 0 || better) match = searched;
  return match;
}

IncrementalMatcher::KnownPoints IncrementalMatcher::known_points(const Hits& hits,
                                                                 const Pose2& predicted) const {
  return kept(hits, local_scans_.known(hits.points, hits.robot_from_laser, predicted));
}

// Hits that say something, and those that lie on the line of a surface beyond its end.
IncrementalMatcher::KnownPoints IncrementalMatcher::points_on_lines(const Hits& hits,
                                                                    const Pose2& pose) const {
  std::vector<bool> keeps = local_scans_.known(hits.points, hits.robot_from_laser, pose);
  for (std::size_t i = 0; i < hits.points.size(); ++i) {
    if (keeps[i]) continue;
    const auto surface = local_scans_.field().surface_at(pose * hits.points[i]);
    keeps[i] = surface && !surface->along.isZero();
  }
  return kept(hits, keeps);
}

IncrementalMatcher::KnownPoints IncrementalMatcher::kept(const Hits& hits,
                                                         const std::vector<bool>& keeps) const {
  std::vector<Eigen::Vector2d> points;
  std::vector<float> searched, climbed;
  for (std::size_t i = 0; i < hits.points.size(); ++i) {
    if (!keeps[i]) continue;
    points.push_back(hits.points[i]);
    const float weight = hits.weights.empty() ? 1.0F : hits.weights[i];
    if (!hits.weights.empty()) searched.push_back(weight);
    if (!hits.footprints.empty()) climbed.push_back(weight * hits.footprints[i]);
  }
  if (hits.footprints.empty()) climbed = searched;
  return {to_field_points(points, local_scans_.field().resolution(), std::move(climbed)),
          std::move(searched)};
}

FieldPoints IncrementalMatcher::KnownPoints::searched() const {
  return {climbed.x, climbed.y, weights};
}

// The best match of the wider search if it explains enough, else `match`.
ScanMatch IncrementalMatcher::searched_widely(const Hits& hits, const Prediction& prediction,
                                              const ScanMatch& match) const {
  const LikelihoodField& field = local_scans_.field();
  const KnownPoints points = known_points(hits, prediction.prior.mean);
  const PosePrior anywhere{.mean = match.map_from_robot};
  const BoundPyramid wide = make_bound_pyramid(field, options_.wide_search.window);
  const ScanMatch found =
      match_correlative(points.searched(), field, wide, anywhere, options_.wide_search);
  ScanMatch refined =
      match_scan_from(found.map_from_robot, points.climbed, field, anywhere, options_.climb);
  refined.contradicts_prediction = true;
  return refined.inlier_ratio >= options_.wide_search.min_inlier_ratio ? refined : match;
}

void IncrementalMatcher::forget_past(bool keep_newest) {
  local_scans_.forget_past(keep_newest);
}

}  // namespace mapbed
