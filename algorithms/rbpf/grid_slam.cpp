#include "algorithms/rbpf/grid_slam.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include <Eigen/Dense>
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "core/check.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

constexpr std::size_t kMinHits = 10;  // of a scan that sees something, as in the matcher

// A belief about the end of a step from a pose that is itself uncertain, with the mean of `step`.
PosePrior chained(const PosePrior& start, const PosePrior& step) {
  const Pose2 motion = motion_between(start.mean, step.mean);
  // How the end moves with the start, each in its own frame.
  const double c = std::cos(motion.theta), s = std::sin(motion.theta);
  Eigen::Matrix3d moves = Eigen::Matrix3d::Identity();
  moves.topLeftCorner<2, 2>() << c, s, -s, c;
  moves.topRightCorner<2, 1>() = moves.topLeftCorner<2, 2>() * Eigen::Vector2d(-motion.y, motion.x);
  const Eigen::Matrix3d covariance = moves * start.information.inverse() * moves.transpose() +
                                     Eigen::Matrix3d(step.information.inverse());
  return {.mean = step.mean, .information = covariance.inverse()};
}

// A pose drawn from a Gaussian.
Pose2 drawn_from(const Pose2& mean, const Eigen::Matrix3d& covariance, Rng& rng) {
  const Eigen::Matrix3d root = covariance.llt().matrixL();
  const Eigen::Vector3d e = root * Eigen::Vector3d(rng.normal(), rng.normal(), rng.normal());
  return mean * Pose2{e.x(), e.y(), normalized_angle(e.z())};
}

}  // namespace

GridSlam::GridSlam(const GridSlamOptions& options, Rng rng)
    : options_(options),
      rng_(rng),
      likelihood_(options.likelihood),
      troubles_(options.troubles),
      matcher_(options.matcher),
      loop_detector_(options.loop_closing) {
  CHECK(options.particles > 0);
}

void GridSlam::add(const Measurement& measurement) {
  if (const auto* odometry = std::get_if<Odometry>(&measurement)) {
    const Odometry passed = troubles_.without_jumps(*odometry);
    odometry_.add(passed);
    matcher_.add(passed);
  }
  if (const auto* scan = std::get_if<LaserScan>(&measurement)) add_scan(*scan);
}

void GridSlam::add_scan(const LaserScan& scan) {
  const std::optional<Pose2> odometry =
      options_.matcher.use_odometry ? odometry_.at(scan.time) : std::optional<Pose2>{};
  const bool first = updates_.empty();
  const auto is_due = [&](const Pose2& motion) {
    return std::hypot(motion.x, motion.y) >= options_.update_distance ||
           std::abs(motion.theta) >= options_.update_turn;
  };

  const auto odometry_since = [&](const std::optional<Pose2>& before) {
    return before && odometry ? std::optional<Pose2>(motion_between(*before, *odometry))
                              : std::optional<Pose2>{};
  };

  const std::vector<Eigen::Vector2d> hits = hit_points(scan, options_.points);
  troubles_.scan(scan.time, odometry_since(odometry_at_scan_), hits.size() >= kMinHits);
  odometry_at_scan_ = odometry;

  // Where the robot is by odometry and scan matching alone.
  const Pose2 matched = track_from_robot_;  // at the last scan that was matched
  const std::optional<Pose2> step = odometry_since(odometry_at_matched_scan_);
  const Pose2 carried = matched * step.value_or(Pose2{});
  Pose2 track = carried;
  Pose2 seen = carried;  // with the help of this scan
  const bool matching = options_.proposal != Proposal::odometry;
  const bool carried_far =
      !first && is_due(motion_between(updates_.back().track_from_robot, carried));
  const bool withheld = matching && carried_far &&
                        (condensed_scans_ > 0 || options_.proposal == Proposal::scan_matching);
  if (matching && !withheld) {
    matcher_.add(scan);
    track = seen = matcher_.pose();
  } else if (withheld) {
    seen = matcher_.match(scan).map_from_robot;
  }

  if (first || is_due(motion_between(updates_.back().track_from_robot, track))) {
    UpdateMotion motion;
    if (!first) {
      const Update& before = updates_.back();
      const bool condensed = condensed_scans_ > 0;
      motion = {.whole = motion_between(before.track_from_robot, track),
                .condensed = condensed ? motion_between(before.seen_from_robot, matched) : Pose2{},
                .step = condensed ? step : odometry_since(odometry_at_update_),
                .seconds = scan.time - scans_.back().time,
                .guess = motion_between(before.seen_from_robot, seen)};
    }
    updates_.push_back({.time = scan.time,
                        .track_from_robot = track,
                        .seen_from_robot = seen,
                        .condensed = motion.condensed,
                        .condensed_until = first ? scan.time : scans_.back().time,
                        .is_condensed = withheld && condensed_scans_ > 0});
    update(scan, motion);
    odometry_at_update_ = odometry;
    condensed_scans_ = 0;
  } else {
    ++condensed_scans_;
  }
  if (!withheld) {
    track_from_robot_ = track;
    odometry_at_matched_scan_ = odometry;
  }
  SeenScan seen_scan{.time = scan.time, .seen_from_robot = seen, .updates = updates_.size()};
  if (updates_.back().time != scan.time) {
    for (const Eigen::Vector2d& hit : hits) {
      seen_scan.hits.push_back(hit.cast<float>());
    }
  }
  scans_.push_back(std::move(seen_scan));
}

void GridSlam::update(const LaserScan& scan, const UpdateMotion& motion) {
  weighting_scans_.push_back(
      scan_for_weighting(scan, options_.points, options_.likelihood, options_.map_resolution));
  const ScanForWeighting& prepared_scan = weighting_scans_.back();
  const std::size_t number = updates_.size() - 1;
  const bool first = particles_.empty();
  if (first) {
    particles_.assign(static_cast<std::size_t>(options_.particles),
                      Particle{.map = SurfaceMap(options_.map_resolution)});
    particles_[0].map.add(transformed(prepared_scan.surface, Pose2{}));
    const auto root = std::make_shared<HistoryNode>(Pose2{}, number, nullptr);
    for (Particle& particle : particles_) {
      particle.map = particles_[0].map;
      particle.history = root;
    }
    updates_.back().effective_number = static_cast<double>(particles_.size());
    return;
  }
  tbb::parallel_for(std::size_t{0}, particles_.size(), [&](std::size_t i) {
    Rng own = rng_.stream("particle", i, number);
    move_and_weight(particles_[i], prepared_scan, motion, own);
  });
  if (prepared_scan.hits.size() >= kMinHits) {
    troubles_.update(scan.time,
                     likelihood_.explained_share(prepared_scan, best().map, best().pose));
  }
  if (options_.best_only_after_loop && closes_loop(prepared_scan)) {
    keep_best_only(updates_.back());
  } else {
    resample_where_needed(updates_.back());
  }
  tbb::parallel_for(std::size_t{0}, particles_.size(), [&](std::size_t i) {
    Particle& particle = particles_[i];
    particle.map.add(transformed(prepared_scan.surface, particle.pose));
    particle.history = std::make_shared<HistoryNode>(particle.pose, number, particle.history);
  });
}

// Where a particle is before the update's scan is looked at: after the condensed motion, whose
// errors are those of matching, and a step of odometry, or one of unknown speed.
PosePrior GridSlam::prior_of(const Particle& particle, const UpdateMotion& motion) const {
  const PosePrior condensed =
      gaussian_after(particle.pose, motion.condensed, options_.matching_errors);
  const PosePrior step =
      motion.step ? gaussian_after(condensed.mean, *motion.step, options_.odometry_errors)
                  : predict_blindly(condensed.mean, {}, motion.seconds, options_.matcher.motion);
  return chained(condensed, step);
}

void GridSlam::move_and_weight(Particle& particle, const ScanForWeighting& scan,
                               const UpdateMotion& motion, Rng& rng) const {
  switch (options_.proposal) {
    case Proposal::odometry:
    case Proposal::scan_matching: {
      const bool raw = options_.proposal == Proposal::odometry;
      const PosePrior prior = raw ? PosePrior{} : prior_of(particle, motion);
      particle.pose =
          raw ? particle.pose * sampled_motion(motion.whole, options_.odometry_errors, rng)
              : drawn_from(prior.mean, prior.information.inverse(), rng);
      particle.log_weight += likelihood_.log_likelihood(scan, particle.map, particle.pose);
      return;
    }
    case Proposal::improved: {
      const Pose2 start = particle.pose * motion.guess;
      const PosePrior prior = prior_of(particle, motion);
      const LocalPosterior posterior =
          likelihood_.local_posterior(start, scan, particle.map, prior);
      particle.pose = drawn_from(posterior.mode, posterior.covariance, rng);
      particle.log_weight += posterior.log_evidence;
      return;
    }
  }
}

void GridSlam::resample_where_needed(Update& update) {
  std::vector<double> log_weights;
  for (const Particle& particle : particles_) log_weights.push_back(particle.log_weight);
  const std::vector<double> weights = normalized(log_weights);
  update.effective_number = effective_number(weights);
  const auto count = static_cast<double>(particles_.size());
  update.resampled = options_.resampling == Resampling::always ||
                     (options_.resampling == Resampling::selective &&
                      update.effective_number < options_.resample_below * count);
  // Kept relative to the best one, so that sums stay small over any length of log.
  const double largest = *std::max_element(log_weights.begin(), log_weights.end());
  for (Particle& particle : particles_) particle.log_weight -= largest;
  if (!update.resampled) return;

  Rng draw = rng_.stream("resampling", updates_.size());
  const std::vector<std::size_t> parents = resampled(weights, draw);
  std::vector<Particle> next;
  next.reserve(particles_.size());
  for (std::size_t i = 0; i < parents.size(); ++i) {
    const bool last_use = i + 1 == parents.size() || parents[i + 1] != parents[i];
    next.push_back(last_use ? std::move(particles_[parents[i]]) : particles_[parents[i]]);
    next.back().log_weight = 0.0;
  }
  particles_ = std::move(next);
}

// By the best particle: where it was at all updates, this one included, and how well its map fits.
bool GridSlam::closes_loop(const ScanForWeighting& scan) {
  const Particle& particle = best();
  std::vector<Pose2> path = path_of(particle);
  path.push_back(particle.pose);
  return loop_detector_.closes(path,
                               likelihood_.explained_share(scan, particle.map, particle.pose));
}

void GridSlam::keep_best_only(Update& update) {
  Particle survivor = best();
  survivor.log_weight = 0.0;
  update.effective_number = 1.0;
  update.resampled = true;
  for (Particle& particle : particles_) particle = survivor;
}

const GridSlam::Particle& GridSlam::best() const {
  CHECK(!particles_.empty());
  return *std::max_element(
      particles_.begin(), particles_.end(),
      [](const Particle& a, const Particle& b) { return a.log_weight < b.log_weight; });
}

Pose2 GridSlam::pose() const {
  if (particles_.empty()) return {};
  return best().pose *
         motion_between(updates_.back().seen_from_robot, scans_.back().seen_from_robot);
}

// Between two updates, carried from both by odometry and scan matching.
PosePrior GridSlam::prior_of(const SeenScan& scan, const std::vector<Pose2>& update_poses) const {
  const std::size_t before = scan.updates - 1;
  const auto carried_from = [&](std::size_t update) {
    return gaussian_after(update_poses[update],
                          motion_between(updates_[update].seen_from_robot, scan.seen_from_robot),
                          motion_errors());
  };
  if (before + 1 >= updates_.size()) return carried_from(before);
  return together(carried_from(before), carried_from(before + 1));
}

// Its poses at the updates that are in its history.
std::vector<Pose2> GridSlam::path_of(const Particle& particle) const {
  std::vector<Pose2> path(particle.history->update + 1);
  for (const HistoryNode* node = particle.history.get(); node != nullptr;
       node = node->parent.get()) {
    path[node->update] = node->pose;
  }
  return path;
}

// The same, without what drawing added.
SettledPath GridSlam::settled_path(const Particle& particle) const {
  const std::vector<Pose2> poses = path_of(particle);
  std::vector<PathStep> path;
  path.reserve(poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Pose2 motion =
        i == 0 ? Pose2{}
               : motion_between(updates_[i - 1].seen_from_robot, updates_[i].seen_from_robot);
    path.push_back({poses[i], motion, &weighting_scans_[i]});
  }
  return settled(std::move(path), motion_errors(), options_.settling);
}

std::vector<GridSlam::Motion> GridSlam::motions() const {
  std::vector<Motion> result;
  for (std::size_t i = 1; i < updates_.size(); ++i) {
    if (!updates_[i].is_condensed) continue;
    result.push_back({updates_[i - 1].time, updates_[i].condensed_until, updates_[i].condensed});
  }
  return result;
}

Hypotheses GridSlam::hypotheses() const {
  Hypotheses result;
  result.diversity = diversity();
  std::unordered_set<const HistoryNode*> drawn;
  for (const Particle& particle : particles_) {
    Trajectory branch;
    for (const HistoryNode* node = particle.history.get(); node != nullptr;
         node = node->parent.get()) {
      branch.push_back({updates_[node->update].time, node->pose});
      if (!drawn.insert(node).second) break;
    }
    std::reverse(branch.begin(), branch.end());
    if (branch.size() > 1) result.branches.push_back(std::move(branch));
  }
  return result;
}

Estimate GridSlam::estimate() const {
  if (particles_.empty()) return {};
  const SettledPath path = settled_path(best());
  Estimate result;
  result.trajectory.reserve(scans_.size());
  for (const SeenScan& scan : scans_) {
    const bool at_update = updates_[scan.updates - 1].time == scan.time;
    Pose2 pose = path.poses[scan.updates - 1];
    if (!at_update) {
      const PosePrior prior = prior_of(scan, path.poses);
      std::vector<Eigen::Vector2d> hits(scan.hits.size());
      for (std::size_t i = 0; i < hits.size(); ++i) hits[i] = scan.hits[i].cast<double>();
      pose = settled_beside(hits, prior, path.map, options_.settling);
    }
    result.trajectory.push_back({scan.time, pose});
  }
  result.untrusted_scans = matcher_.estimate().untrusted_scans;
  for (std::string& remark : troubles_.remarks()) result.remarks.push_back(std::move(remark));
  const auto resamplings =
      std::count_if(updates_.begin(), updates_.end(), [](const Update& u) { return u.resampled; });
  result.remarks.push_back(
      fmt::format("{} particles, {} updates, {} resamplings; today's particles descend from {} of "
                  "the first tenth",
                  particles_.size(), updates_.size(), resamplings,
                  diversity()[updates_.size() / 10].distinct_ancestors));
  return result;
}

std::vector<Diversity> GridSlam::diversity() const {
  std::vector<Diversity> result(updates_.size());
  std::unordered_set<const HistoryNode*> generation;
  for (const Particle& particle : particles_) generation.insert(particle.history.get());
  for (std::size_t i = updates_.size(); i-- > 0;) {
    result[i] = {.time = updates_[i].time,
                 .distinct_ancestors = static_cast<int>(generation.size()),
                 .effective_number = updates_[i].effective_number,
                 .resampled = updates_[i].resampled};
    std::unordered_set<const HistoryNode*> before;
    for (const HistoryNode* node : generation) before.insert(node->parent.get());
    generation = std::move(before);
  }
  return result;
}

}  // namespace mapbed
