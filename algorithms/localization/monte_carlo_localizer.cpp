#include "algorithms/localization/monte_carlo_localizer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "algorithms/particles/resampling.h"
#include "core/check.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

constexpr double kSamePlace = 1.0;    // [m] from where the robot was taken to be, or less
constexpr double kSameHeading = 0.5;  // [rad] the same
constexpr std::size_t kTried = 32;    // poses, of which one is drawn by a measurement

Pose2 drawn_about(const Pose2& pose, double sigma, double turn_sigma, Rng& rng) {
  const double x = rng.normal(pose.x, sigma);
  const double y = rng.normal(pose.y, sigma);
  return {x, y, normalized_angle(rng.normal(pose.theta, turn_sigma))};
}

}  // namespace

MonteCarloLocalizer::MonteCarloLocalizer(const MonteCarloOptions& options, const FreeSpace& space,
                                         AllWeights weights, std::optional<Pose2> start,
                                         const Rng& rng)
    : options_(options),
      space_(space),
      weights_(std::move(weights)),
      likelihoods_(weights_.size(), LikelihoodMeans(options.recovery)),
      taken_(weights_.size()),
      start_(std::move(start)),
      rng_(rng),
      place_(start_ ? options.confidence : 0.5) {
  CHECK(!space.empty() && !weights_.empty());
}

void MonteCarloLocalizer::add(const Measurement& measurement, std::span<const float> beam_weights) {
  if (const auto* odometry = std::get_if<Odometry>(&measurement)) odometry_.add(*odometry);
  const auto* scan = std::get_if<LaserScan>(&measurement);
  if (scan != nullptr && !lasers_.take(*scan)) return;
  const double time = time_of(measurement);
  for (std::size_t sensor = 0; sensor < weights_.size(); ++sensor) {
    ParticleWeights& weights = *weights_[sensor];
    if (!is_due(sensor, time) || !weights.take(measurement, beam_weights)) continue;
    const bool begins = poses_.empty();
    const Pose2 predicted = pose_at(time);
    if (!begins) move_until(time);
    const bool is_drawn_by_it = begins && begin(weights);
    updated_ = time;
    odometry_at_update_ = odometry_.at(time);
    taken_[sensor] = {time, odometry_at_update_};
    weigh(sensor, is_drawn_by_it);
    judge(weights, begins ? answer_.mean : predicted);
    draw_anew(sensor);
    ++updates_;
  }
  if (scan != nullptr) tell_pose(time, of_scans_);
  if (std::holds_alternative<RfidDetections>(measurement)) tell_pose(time, of_rounds_);
}

void MonteCarloLocalizer::tell_pose(double time, Told& told) const {
  told.trajectory.push_back({time, pose_at(time)});
  told.covariances.push_back(answer_.covariance);
  told.known.add(time, state());
}

// Of a log without scans its inventory rounds have poses.
const MonteCarloLocalizer::Told& MonteCarloLocalizer::told() const {
  return of_scans_.trajectory.empty() ? of_rounds_ : of_scans_;
}

// Whether the robot has moved enough for a sensor that repeats itself.
bool MonteCarloLocalizer::is_due(std::size_t sensor, double time) const {
  const std::optional<Taken>& last = taken_[sensor];
  if (poses_.empty() || !last || !weights_[sensor]->repeats_at_rest()) return true;
  if (time - last->time >= options_.update_time) return true;
  const std::optional<Pose2> motion = motion_between_times(last->odometry, time);
  if (!motion) return true;
  return std::hypot(motion->x, motion->y) >= options_.update_distance ||
         std::abs(motion->theta) >= options_.update_turn;
}

std::optional<Pose2> MonteCarloLocalizer::motion_until(double time) const {
  return motion_between_times(odometry_at_update_, time);
}

// By odometry, from where it was `then`.
std::optional<Pose2> MonteCarloLocalizer::motion_between_times(const std::optional<Pose2>& then,
                                                               double time) const {
  if (options_.motion != ParticleMotion::odometry || !then) return {};
  const std::optional<Pose2> odometry = odometry_.at(time);
  if (!odometry) return {};
  return motion_between(*then, *odometry);
}

// Fox's way: so many are drawn as the boxes that they come to lie in ask for. True: where the
// measurement may be from, so that it has had its say.
bool MonteCarloLocalizer::begin(const ParticleWeights& weights) {
  Rng rng = rng_.stream("start");
  bool by_sensor = false;
  const auto drawn = [&] {
    if (start_) return drawn_about(*start_, options_.start_sigma, options_.start_turn_sigma, rng);
    const std::optional<Pose2> proposed =
        options_.start_by_sensor ? weights.propose(rng) : std::optional<Pose2>{};
    by_sensor = proposed.has_value();
    return proposed ? *proposed : space_.sample(rng);
  };
  for (std::size_t wanted = 1; poses_.size() < wanted;) {
    while (poses_.size() < wanted) poses_.push_back(drawn());
    wanted = particle_number(occupied_bins(poses_, options_.bins), options_.particles);
  }
  log_weights_.assign(poses_.size(), 0.0);
  return by_sensor;
}

void MonteCarloLocalizer::move_until(double time) {
  const Rng streams = rng_.stream("motion", static_cast<std::uint64_t>(updates_));
  if (const std::optional<Pose2> motion = motion_until(time)) {
    move_particles(poses_, *motion, options_.odometry, streams);
  } else {
    move_particles(poses_, time - updated_, options_.random_step, streams);
    if (options_.motion == ParticleMotion::odometry) ++without_odometry_;
  }
}

// The correction of (7.3).
void MonteCarloLocalizer::weigh(std::size_t sensor, bool is_drawn_by_it) {
  if (!is_drawn_by_it) {
    const std::vector<double> before = normalized(log_weights_);
    std::vector<double> logs(poses_.size(), 0.0);
    weights_[sensor]->add_log_weights(poses_, logs);
    likelihood_ = 0.0;
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      likelihood_ += before[i] * std::exp(logs[i]);
      log_weights_[i] += logs[i];
    }
  }
  answer_ = answer_of(poses_, normalized(log_weights_), options_.bins);
  if (is_narrow()) likelihoods_[sensor].add(weights_[sensor]->likelihood_of_reading(answer_.mean));
}

// Whether the robot is there. What was believed of another place says nothing of this one.
void MonteCarloLocalizer::judge(const ParticleWeights& weights, const Pose2& predicted) {
  const bool is_same_place =
      distance(answer_.mean, predicted) <= kSamePlace &&
      std::abs(angle_difference(answer_.mean.theta, predicted.theta)) <= kSameHeading;
  if (!is_same_place) place_.doubt();
  const std::optional<double> odds = weights.log_odds_of_map(answer_.mean);
  if (odds) place_.add(is_narrow() ? *odds : 0.0);
}

// Of the particles, to be drawn anywhere: the robot is rather not where it is taken to be.
double MonteCarloLocalizer::doubt() const {
  return options_.recovery.most * std::max(0.0, 1.0 - 2.0 * place_.probability());
}

// The same while it is taken to be in several places: what was measured is less likely from these
// than from where it may have been measured (sensor resetting, Lenser and Veloso, 2000).
double MonteCarloLocalizer::poverty(const ParticleWeights& weights, Rng& rng) const {
  std::vector<Pose2> proposed;
  for (std::size_t i = 0; i < kTried; ++i) proposed.push_back(drawn_anywhere(weights, rng));
  std::vector<double> logs(proposed.size(), 0.0);
  weights.add_log_weights(proposed, logs);
  double sum = 0.0;
  for (const double log : logs) sum += std::exp(log);
  const double mean = sum / static_cast<double>(logs.size());
  return mean > 0.0 ? options_.recovery.most * std::max(0.0, 1.0 - likelihood_ / mean) : 0.0;
}

void MonteCarloLocalizer::draw_anew(std::size_t sensor) {
  const std::vector<double> weights = normalized(log_weights_);
  Rng rng = rng_.stream("drawing", static_cast<std::uint64_t>(updates_));
  const double near = is_narrow() ? likelihoods_[sensor].fraction_to_draw() : 0.0;
  const double anywhere = is_narrow() ? doubt() : poverty(*weights_[sensor], rng);
  const double least = options_.resample_below * static_cast<double>(poses_.size());
  if (near + anywhere == 0.0 && effective_number(weights) >= least) return;

  const auto drawn = [&](std::size_t count) {
    std::vector<Pose2> poses;
    for (const std::size_t parent : resampled(weights, count, rng)) {
      poses.push_back(poses_[parent]);
    }
    return poses;
  };
  std::vector<Pose2> next = drawn(poses_.size());
  const std::size_t bins = occupied_bins(next, options_.bins);
  const std::size_t number = particle_number(bins, options_.particles);
  if (number != next.size()) next = drawn(number);
  // Spread over the old ones, which stand by their ancestors.
  const auto size = static_cast<double>(next.size());
  const auto fresh = static_cast<std::size_t>((near + anywhere) * size);
  const auto fresh_near = static_cast<std::size_t>(near * size);
  for (std::size_t i = 0; i < fresh; ++i) {
    Pose2& pose = next[i * next.size() / fresh];
    const bool is_near = (i + 1) * fresh_near / fresh > i * fresh_near / fresh;
    pose =
        is_near ? drawn_near(pose, *weights_[sensor], rng) : drawn_anywhere(*weights_[sensor], rng);
  }
  poses_ = std::move(next);
  log_weights_.assign(poses_.size(), 0.0);
}

Pose2 MonteCarloLocalizer::drawn_anywhere(const ParticleWeights& weights, Rng& rng) const {
  const std::optional<Pose2> proposed = weights.propose(rng);
  return proposed ? *proposed : space_.sample(rng);
}

Pose2 MonteCarloLocalizer::drawn_near(const Pose2& pose, const ParticleWeights& weights,
                                      Rng& rng) const {
  std::vector<Pose2> tried;
  for (std::size_t i = 0; i < kTried; ++i) {
    tried.push_back(drawn_about(pose, options_.recovery.sigma, options_.recovery.turn_sigma, rng));
  }
  return drawn_by(weights, tried, rng);
}

Unknown MonteCarloLocalizer::state() const {
  if (poses_.empty()) return Unknown::several;
  const bool is_one =
      answer_.weight >= options_.confidence && answer_.largest_sigma() <= options_.known_sigma;
  const double place = place_.probability();
  if (is_one && place >= options_.confidence) return Unknown::none;
  return is_one || place < 0.5 ? Unknown::nowhere : Unknown::several;
}

Pose2 MonteCarloLocalizer::pose_at(double time) const {
  if (poses_.empty()) return start_.value_or(Pose2{});
  return answer_.mean * motion_until(time).value_or(Pose2{});
}

Pose2 MonteCarloLocalizer::pose() const {
  const Trajectory& trajectory = told().trajectory;
  return trajectory.empty() ? start_.value_or(Pose2{}) : pose_at(trajectory.back().time);
}

Estimate MonteCarloLocalizer::estimate() const {
  const Told& told = this->told();
  Estimate result{.trajectory = told.trajectory,
                  .covariances = told.covariances,
                  .lost = told.known.lost(),
                  .remarks = lasers_.remarks()};
  if (told.trajectory.empty()) return result;
  if (without_odometry_ > 0) {
    result.remarks.push_back({RemarkKind::no_odometry,
                              fmt::format("no odometry before {} updates: particles were moved by "
                                          "random steps",
                                          without_odometry_)});
  }
  for (Remark& remark : told.known.remarks(told.trajectory.front().time)) {
    result.remarks.push_back(std::move(remark));
  }
  return result;
}

}  // namespace mapbed
