#include "algorithms/localization/beam_model_weights.h"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

#include "algorithms/grid/traversal.h"

namespace mapbed {
namespace {

constexpr double kReach = 3.0;  // [sigma] farther from a wall a beam did not end on it

}  // namespace

bool BeamModelWeights::take(const Measurement& measurement, std::span<const float> beam_weights) {
  if (!LaserWeights::take(measurement, beam_weights)) return false;
  const auto& scan = std::get<LaserScan>(measurement);
  const std::vector<Eigen::Vector2d> ends = hit_points(scan, options().points);
  const std::vector<float> weights = hit_point_weights(scan, options().points, beam_weights);
  rays_.clear();
  for (std::size_t i = 0; i < ends.size(); ++i) {
    rays_.push_back({scan.robot_from_laser.planar.position(), ends[i],
                     weights.empty() ? 1.0 : double{weights[i]}});
  }
  return true;
}

double BeamModelWeights::log_likelihood(const Ray& ray, const Pose2& map_from_robot) const {
  const OccupancyMap& map = space().map();
  const double w = options().inlier_ratio;
  const double reach = kReach * options().sigma;
  const Eigen::Vector2d start = map_from_robot * ray.from;
  const Eigen::Vector2d end = map_from_robot * ray.to;
  const double range = (end - start).norm();
  const Eigen::Vector2d beyond = start + (range + reach) / range * (end - start);
  double way = 0.0;        // [m] up to the cell
  double wall = HUGE_VAL;  // [m] to the middle of the beam's way in the first occupied cell
  const auto visit = [&](CellIndex cell, double length) {
    if (wall == HUGE_VAL && is_occupied(map[cell])) wall = way + 0.5 * length;
    way += length;
  };
  const CoveredCell last = traverse(start, beyond, map.frame(), visit);
  visit(last.cell, last.length);
  const double off = (range - wall) / options().sigma;
  if (off > kReach) return std::log(options().through_wall * (1.0 - w));
  if (off < -kReach) return std::log(1.0 - w);
  return std::log(w * std::exp(-0.5 * off * off) + 1.0 - w);
}

void BeamModelWeights::add_log_weights(std::span<const Pose2> map_from_robot,
                                       std::span<double> log_weights) const {
  tbb::parallel_for(std::size_t{0}, map_from_robot.size(), [&](std::size_t i) {
    double sum = 0.0;
    for (const Ray& ray : rays_) sum += ray.weight * log_likelihood(ray, map_from_robot[i]);
    log_weights[i] += options().beam_weight * sum;
  });
}

std::unique_ptr<ParticleWeights> make_laser_weights(const LaserWeightOptions& options,
                                                    const FreeSpace& space, const Rng& rng) {
  if (options.model == LaserModel::beam) {
    return std::make_unique<BeamModelWeights>(options, space, rng);
  }
  return std::make_unique<LaserWeights>(options, space, rng);
}

}  // namespace mapbed
