#include "algorithms/rbpf/grid_slam.h"

#include <algorithm>
#include <utility>

#include <Eigen/Dense>
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "algorithms/particles/hypotheses.h"
#include "algorithms/rbpf/place_search.h"
#include "algorithms/scan/beam_weights.h"
#include "core/check.h"

namespace mapbed {
namespace {

constexpr std::size_t kMinHits = 10;  // of a scan that sees something, as in the matcher

}  // namespace

GridSlam::GridSlam(const GridSlamOptions& options, Rng rng, const Pose2& start)
    : options_(options),
      rng_(rng),
      start_(start),
      likelihood_(options.likelihood),
      diagnostics_(options.input_diagnostics, options.proposal != Proposal::odometry),
      front_end_({options.proposal, options.update_distance, options.update_turn, options.matcher}),
      loop_detector_(options.loop_closing) {
  CHECK(options.particles > 0);
}

void GridSlam::add(const Measurement& measurement, std::span<const float> beam_weights) {
  if (const auto* odometry = std::get_if<Odometry>(&measurement)) {
    diagnostics_.odometry(*odometry);
    front_end_.add(*odometry);
  }
  const auto* scan = std::get_if<LaserScan>(&measurement);
  if (scan != nullptr && lasers_.take(*scan)) {
    add_scan(beam_weights.empty() ? *scan : with_failed_beams(*scan, beam_weights), beam_weights);
  }
}

void GridSlam::add_scan(const LaserScan& scan, std::span<const float> beam_weights) {
  const std::vector<Eigen::Vector2d> hits = hit_points(scan, options_.points);
  const FrontEnd::Result condensed = front_end_.add(scan, beam_weights);
  // A laser that told nothing new is not blind.
  diagnostics_.scan(scan.time, condensed.step, hits.size() >= kMinHits || scan.ranges.empty(),
                    condensed.fits || hits.size() < kMinHits);
  if (condensed.update) update(scan, beam_weights, *condensed.update);
  if (!options_.refinement.enabled) return;
  KeptHits& kept = hits_.emplace_back();
  if (condensed.update) return;
  for (const Eigen::Vector2d& hit : hits) kept.push_back(hit.cast<float>());
}

void GridSlam::update(const LaserScan& scan, std::span<const float> beam_weights,
                      const UpdateMotion& motion) {
  weighting_scans_.push_back(scan_for_weighting(scan, options_.points, options_.likelihood,
                                                options_.map_resolution, beam_weights));
  updates_.push_back({.time = scan.time});
  const ScanForWeighting& prepared_scan = weighting_scans_.back();
  const std::size_t number = updates_.size() - 1;
  if (particles_.empty()) {
    start();
    return;
  }
  const std::vector<double> weights_before = log_weights();
  const ScanForWeighting& scan_before = weighting_scans_[number - 1];
  UpdateMotion searched = motion;
  searched.other_guess = other_guess(prepared_scan, scan_before, motion);
  tbb::parallel_for(std::size_t{0}, particles_.size(), [&](std::size_t i) {
    Rng own = rng_.stream("particle", i, number);
    particles_[i].map.add(scan_before.surface, particles_[i].history->pose);
    move_and_weight(particles_[i], prepared_scan, searched, own);
  });
  const bool sees = prepared_scan.hits.size() >= kMinHits;
  if (sees && relocalized(prepared_scan, weights_before)) return;
  if (options_.best_only_after_loop && closes_loop(prepared_scan)) {
    keep_best_only();
  } else {
    resample_where_needed();
  }
  const auto remember = [number](Particle& particle) {
    particle.history = std::make_shared<HistoryNode>(particle.pose, number, particle.history);
  };
  std::for_each(particles_.begin(), particles_.end(), remember);
}

// All particles with the first scan, where the robot starts.
void GridSlam::start() {
  const auto root = std::make_shared<HistoryNode>(start_, 0, nullptr);
  const Particle first{.pose = start_, .map = SurfaceMap(options_.map_resolution), .history = root};
  particles_.assign(static_cast<std::size_t>(options_.particles), first);
  updates_.back().effective_number = static_cast<double>(particles_.size());
}

// Whether the robot is where the particles have it. True where it is not, but was found elsewhere:
// then the particles were made anew, with this update's scan.
bool GridSlam::relocalized(const ScanForWeighting& scan,
                           const std::vector<double>& weights_before) {
  const double time = updates_.back().time;
  const double inlier_ratio = likelihood_.inlier_ratio(scan, best().map, best().pose);
  const std::optional<double> interruption = diagnostics_.interruption();
  if (interruption || (diagnostics_.loses(inlier_ratio) && !relocalization_)) {
    begin_relocalization(interruption.value_or(time), weights_before);
  }
  GlobalLocalizer::Answer place{.confirmed = true};
  if (relocalization_)
    place = relocalization_->find({weighting_scans_, front_end_.updates()}, best().pose);
  diagnostics_.update(time, inlier_ratio, place.confirmed || place.plausible);
  if (place.relocated_to) {
    restart_at(*place.relocated_to);
    front_end_.forget_past();
  } else if (interruption && !place.confirmed && !front_end_.newest_is_matched()) {
    // Elsewhere than odometry tells. Where nothing but the scan says so, as among trees, scans to
    // come need the past.
    front_end_.forget_past();
  }
  const bool over = place.confirmed || place.relocated_to ||
                    relocalization_->gives_up({weighting_scans_, front_end_.updates()});
  if (over) relocalization_.reset();
  return place.relocated_to.has_value();
}

// The robot may be anywhere with this update; the particles' maps do not know its scan yet. What
// was seen since an interruption before that lies elsewhere again.
void GridSlam::begin_relocalization(double since, const std::vector<double>& weights_before) {
  if (options_.relocalization.max_updates == 0) return;
  std::vector<Particle> before = particles_;
  for (std::size_t i = 0; i < before.size(); ++i) before[i].log_weight = weights_before[i];
  relocalization_.emplace(since, std::move(before),
                          Relocalization::Updates{weighting_scans_, front_end_.updates()},
                          options_.relocalization);
}

void GridSlam::restart_at(const Pose2& found) {
  particles_ = relocalization_->restarted(found, {weighting_scans_, front_end_.updates()},
                                          likelihood_, options_.matching_errors, rng_);
  resample_where_needed();
  diagnostics_.relocalized(relocalization_->since(), updates_.back().time);
  breaks_.push_back({relocalization_->since(), relocalization_->first_update()});
}

PosePrior GridSlam::prior_of(const Particle& particle, const UpdateMotion& motion) const {
  return prior_after(
      particle.pose, motion,
      {options_.matching_errors, options_.odometry_errors, options_.matcher.motion,
       options_.matcher.wide_search.window, options_.matcher.wide_search.turn_window});
}

// Where the best particle's map explains clearly more of the scan than near the front end's guess.
std::optional<Pose2> GridSlam::other_guess(const ScanForWeighting& scan,
                                           const ScanForWeighting& before,
                                           const UpdateMotion& motion) const {
  if (options_.proposal != Proposal::improved || motion.step_contradicted) return {};
  if (scan.hits.size() < kMinHits) return {};
  const Particle& particle = best();
  SurfaceMap map = particle.map;
  map.add(before.surface, particle.history->pose);
  // As the matcher has them for a match that does not convince, and for one that is not trusted.
  const double enough = motion.guess_is_doubtful ? options_.matcher.search_below
                                                 : options_.matcher.climb.min_inlier_ratio;
  const std::optional<Pose2> found = likelier_place(
      particle.pose * motion.guess, scan, map, prior_of(particle, motion), likelihood_, enough);
  if (!found) return {};
  return motion_between(particle.pose, *found);
}

void GridSlam::move_and_weight(Particle& particle, const ScanForWeighting& scan,
                               const UpdateMotion& motion, Rng& rng) const {
  // Where odometry is known to be wrong, the scan alone says where to draw.
  const bool from_scan = options_.proposal == Proposal::improved ||
                         (options_.proposal == Proposal::scan_matching && motion.step_contradicted);
  if (from_scan) {
    const PosePrior prior = prior_of(particle, motion);
    LocalPosterior posterior =
        likelihood_.local_posterior(particle.pose * motion.guess, scan, particle.map, prior);
    if (motion.other_guess) {
      const LocalPosterior other = likelihood_.local_posterior(particle.pose * *motion.other_guess,
                                                               scan, particle.map, prior);
      const double odds = std::exp(other.log_evidence - posterior.log_evidence);
      if (rng.uniform() * (1.0 + odds) >= 1.0) posterior = other;
    }
    particle.pose = drawn_from(posterior.mode, posterior.covariance, rng);
    particle.log_weight += posterior.log_evidence;
    return;
  }
  if (options_.proposal == Proposal::odometry) {
    particle.pose = particle.pose * sampled_motion(motion.whole, options_.odometry_errors, rng);
  } else {
    const PosePrior prior = prior_of(particle, motion);
    particle.pose = drawn_from(prior.mean, prior.information.inverse(), rng);
  }
  particle.log_weight += likelihood_.log_likelihood(scan, particle.map, particle.pose);
}

std::vector<double> GridSlam::log_weights() const {
  std::vector<double> result;
  for (const Particle& particle : particles_) result.push_back(particle.log_weight);
  return result;
}

void GridSlam::resample_where_needed() {
  Diversity& update = updates_.back();
  const std::vector<double> log_weights = this->log_weights();
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
  std::vector<Pose2> path = path_of(*particle.history);
  path.push_back(particle.pose);
  return loop_detector_.closes(path, likelihood_.inlier_ratio(scan, particle.map, particle.pose));
}

void GridSlam::keep_best_only() {
  Particle survivor = best();
  survivor.log_weight = 0.0;
  updates_.back().effective_number = 1.0;
  updates_.back().resampled = true;
  for (Particle& particle : particles_) particle = survivor;
}

const Particle& GridSlam::best() const {
  CHECK(!particles_.empty());
  return *std::max_element(
      particles_.begin(), particles_.end(),
      [](const Particle& a, const Particle& b) { return a.log_weight < b.log_weight; });
}

Pose2 GridSlam::pose() const {
  if (particles_.empty()) return start_;
  return best().pose * motion_between(front_end_.updates().back().seen_from_robot,
                                      front_end_.scans().back().track_from_robot);
}

std::vector<GridSlam::Motion> GridSlam::motions() const {
  const std::vector<FrontEnd::Update>& updates = front_end_.updates();
  std::vector<Motion> result;
  for (std::size_t i = 1; i < updates.size(); ++i) {
    if (!updates[i].is_condensed) continue;
    result.push_back({updates[i - 1].time, updates[i].condensed_until, updates[i].condensed});
  }
  return result;
}

std::vector<const HistoryNode*> GridSlam::pasts() const {
  std::vector<const HistoryNode*> result;
  for (const Particle& particle : particles_) result.push_back(particle.history.get());
  return result;
}

Trajectory GridSlam::path_so_far() const {
  if (particles_.empty()) return {};
  return carried_trajectory(track(), path_of(*best().history));
}

Hypotheses GridSlam::hypotheses() const {
  return {branches_of(pasts(), updates_), diversity_of(pasts(), updates_)};
}

Track GridSlam::track() const {
  Track track{.scans = front_end_.scans(),
              .track_from_anchors = {},
              .breaks = breaks_,
              .errors = motion_errors()};
  for (const FrontEnd::Update& update : front_end_.updates()) {
    track.track_from_anchors.push_back(update.seen_from_robot);
  }
  return track;
}

Estimate GridSlam::estimate() const {
  if (particles_.empty()) return {};
  const std::vector<Pose2> path = path_of(*best().history);
  const Track track = this->track();
  Estimate result;
  if (options_.refinement.enabled) {
    const RefinedPath better = refined(path, weighting_scans_, track, options_.refinement);
    result.trajectory = refined_trajectory(better, track, hits_, options_.refinement);
  } else {
    result.trajectory = carried_trajectory(track, path);
  }
  result.untrusted_scans = front_end_.untrusted_scans();
  result.lost = diagnostics_.lost();
  result.remarks = lasers_.remarks();
  for (Remark& remark : diagnostics_.remarks()) result.remarks.push_back(std::move(remark));
  for (Remark& remark : front_end_.remarks_on_unknown_motion()) {
    result.remarks.push_back(std::move(remark));
  }
  const auto resamplings = std::count_if(updates_.begin(), updates_.end(),
                                         [](const Diversity& u) { return u.resampled; });
  result.remarks.push_back(
      {RemarkKind::note,
       fmt::format("{} particles, {} updates, {} resamplings; today's particles descend from {} of "
                   "the first tenth",
                   particles_.size(), updates_.size(), resamplings,
                   diversity_of(pasts(), updates_)[updates_.size() / 10].distinct_ancestors)});
  return result;
}

}  // namespace mapbed
