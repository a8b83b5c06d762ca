#include "algorithms/localization/laser_weights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "core/check.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

constexpr std::size_t kMinPoints = 10;  // fewer say nothing about a pose
constexpr std::size_t kPlaces = 3000;   // that are looked at for v0
constexpr std::size_t kClimbed = 30;    // the best of them, from which the search goes on
constexpr double kFirstStep = 0.2;      // [m] of that search
constexpr double kLastStep = 0.04;      // [m]
constexpr double kTurnPerStep = 0.5;    // [rad/m]
constexpr double kOtherPlace = 1.0;     // [m] from a pose: another place
constexpr double kOtherHeading = 0.5;   // [rad] the same
constexpr double kAsMany = 0.8;         // of the points that the map tells of here
constexpr double kLeastTold = 0.5;  // of a scan: a map that tells less does not show where that was
constexpr double kLeastDifference = 0.05;  // of v0 to v1
constexpr std::size_t kTried = 32;         // places, of which one is proposed

std::vector<Pose2> places(const FreeSpace& space, std::size_t count, Rng& rng) {
  std::vector<Pose2> result;
  for (std::size_t i = 0; i < count; ++i) result.push_back(space.sample(rng));
  return result;
}

}  // namespace

LaserWeights::LaserWeights(const LaserWeightOptions& options, const FreeSpace& space, Rng rng)
    : options_(options),
      space_(space),
      table_(space.map(), options.sigma, options.inlier_ratio),
      rng_(std::move(rng)) {
  CHECK(!space.empty());
}

bool LaserWeights::take(const Measurement& measurement, std::span<const float> beam_weights) {
  const auto* scan = std::get_if<LaserScan>(&measurement);
  if (scan == nullptr) return false;
  FieldPoints points = to_field_points(hit_points(*scan, options_.points), table_.resolution(),
                                       hit_point_weights(*scan, options_.points, beam_weights));
  if (points.total_weight() < kMinPoints) return false;
  points_ = std::move(points);
  look_for_places();
  return true;
}

// Uphill to the best place about.
LaserWeights::Place LaserWeights::climbed(Place place) const {
  for (double step = kFirstStep; step >= kLastStep;) {
    const double turn = kTurnPerStep * step;
    Place best = place;
    for (const Pose2& move : {Pose2{step, 0, 0}, Pose2{-step, 0, 0}, Pose2{0, step, 0},
                              Pose2{0, -step, 0}, Pose2{0, 0, turn}, Pose2{0, 0, -turn}}) {
      const Pose2 pose = place.map_from_robot * move;
      const float log = table_.sum(pose, points_);
      if (log > best.log) best = {pose, log};
    }
    if (best.log > place.log) {
      place = best;
    } else {
      step /= 2.0;
    }
  }
  return place;
}

void LaserWeights::look_for_places() {
  const std::vector<Pose2> poses = places(space_, kPlaces, rng_);
  std::vector<float> sums(poses.size());
  table_.sums(poses, points_, sums);
  best_.clear();
  for (std::size_t i = 0; i < poses.size(); ++i) best_.push_back({poses[i], sums[i]});
  std::partial_sort(best_.begin(), best_.begin() + kClimbed, best_.end(),
                    [](const Place& a, const Place& b) { return a.log > b.log; });
  best_.resize(kClimbed);
  for (Place& place : best_) place = climbed(place);
}

std::vector<double> LaserWeights::by_end_points(std::span<const Pose2> map_from_robot) const {
  std::vector<float> sums(map_from_robot.size());
  table_.sums(map_from_robot, points_, sums);
  std::vector<double> logs;
  logs.reserve(sums.size());
  for (const float sum : sums) logs.push_back(options_.beam_weight * double{sum});
  return logs;
}

void LaserWeights::add_log_weights(std::span<const Pose2> map_from_robot,
                                   std::span<double> log_weights) const {
  const std::vector<double> logs = by_end_points(map_from_robot);
  for (std::size_t i = 0; i < logs.size(); ++i) log_weights[i] += logs[i];
}

std::optional<Pose2> LaserWeights::propose(Rng& rng) const {
  const std::vector<Pose2> tried = places(space_, kTried, rng);
  return drawn_by(by_end_points(tried), tried, rng);
}

LaserWeights::Explained LaserWeights::explained(const Pose2& map_from_robot) const {
  const EndPointTable::Told told = table_.told(map_from_robot, points_);
  const double n = std::max(told.weight, kLeastTold * points_.total_weight());
  // Each counts with 1 - log / outlier_log, as inlier_ratio() has it.
  const double explained = told.weight - told.log / table_.outlier_log();
  return {n, explained / n};
}

double LaserWeights::likelihood_of_reading(const Pose2& map_from_robot) const {
  const EndPointTable::Told told = table_.told(map_from_robot, points_);
  return told.weight > 0.0 ? std::exp(told.log / told.weight) : 1.0;
}

double LaserWeights::explained_elsewhere(const Pose2& map_from_robot) const {
  const double as_many = kAsMany * explained(map_from_robot).points;
  double most = 0.0;
  for (const Place& place : best_) {
    const bool is_here = distance(place.map_from_robot, map_from_robot) < kOtherPlace &&
                         std::abs(angle_difference(place.map_from_robot.theta,
                                                   map_from_robot.theta)) < kOtherHeading;
    if (is_here) continue;
    const Explained there = explained(place.map_from_robot);
    if (there.points >= as_many) most = std::max(most, there.fraction);
  }
  return most;
}

std::optional<double> LaserWeights::log_odds_of_map(const Pose2& map_from_robot) const {
  const double v1 = options_.inlier_ratio;
  const auto [n, f] = explained(map_from_robot);
  // Where all looks alike, as in a long corridor, what fits still speaks for the map.
  const double by_chance = std::min(f, explained_elsewhere(map_from_robot));
  const double v0 = std::clamp(by_chance, 0.01, v1 - kLeastDifference);
  const double odds = f * std::log(v1 / v0) + (1.0 - f) * std::log((1.0 - v1) / (1.0 - v0));
  return options_.beam_weight * n * odds;
}

}  // namespace mapbed
