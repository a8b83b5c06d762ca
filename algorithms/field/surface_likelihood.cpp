#include "algorithms/field/surface_likelihood.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <Eigen/Dense>

#include "algorithms/field/mapped_line.h"
#include "algorithms/field/surface_map_reader.h"
#include "algorithms/field/surface_terms.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

constexpr double kMaxGap = 0.2;  // [m] neighbouring hits that are nearer belong to one surface
constexpr int kIterations = 4;
constexpr std::size_t kCoarse = 3;     // the first step is taken by every third hit
constexpr std::size_t kManyHits = 40;  // of fewer by all
constexpr double kConverged = 2e-3;    // [m], [rad] the step after that is far smaller still
constexpr int kMixtureSteps = 512;
constexpr double kReach = 4.0;  // [sigma] beyond, the Gaussian counts for nothing

// Of a point to the mapped surface [m^2].
float squared_distance(const SurfaceMap::Nearest& nearest) {
  return MappedLine(nearest.doubled_x, nearest.doubled_y)
      .squared_distance(nearest.off_x, nearest.off_y);
}

// The mapped surfaces nearest to hits.count of the hits from the first on, which stand `every`
// apart.
void find_surfaces(const Eigen::Vector2d* first, std::size_t every, const Pose2& map_from_robot,
                   SurfaceMap::Reader& reader, HitsOnSurface& hits) {
  const double c = std::cos(map_from_robot.theta), s = std::sin(map_from_robot.theta);
  run(this_processor(), [&, c, s]() MAPBED_INLINE_LOOP {
    std::array<double, HitsOnSurface::kMost> x, y;  // [cells] in the map
    std::array<int, HitsOnSurface::kMost> cell_x, cell_y;
    const double scale = reader.cells_per_meter();
    for (std::size_t k = 0; k < hits.count; ++k) {
      const double hit_x = first[every * k].x(), hit_y = first[every * k].y();
      const double arm_x = c * hit_x - s * hit_y, arm_y = s * hit_x + c * hit_y;
      hits.arm_x[k] = static_cast<float>(arm_x);
      hits.arm_y[k] = static_cast<float>(arm_y);
      x[k] = (map_from_robot.x + arm_x) * scale;
      y[k] = (map_from_robot.y + arm_y) * scale;
      cell_x[k] = SurfaceMap::Reader::floor_of(x[k]);
      cell_y[k] = SurfaceMap::Reader::floor_of(y[k]);
    }
    for (std::size_t k = 0; k < hits.count; ++k) {
      const SurfaceMap::Nearest nearest = reader.nearest(x[k], y[k], cell_x[k], cell_y[k]);
      hits.found[k] = nearest.found ? 1 : 0;
      hits.off_x[k] = nearest.off_x;
      hits.off_y[k] = nearest.off_y;
      hits.doubled_x[k] = nearest.doubled_x;
      hits.doubled_y[k] = nearest.doubled_y;
    }
  });
}

// One hit after the other.
struct SumOfTerms {
  float log = 0.0F, gx = 0.0F, gy = 0.0F, gt = 0.0F;
  float xx = 0.0F, xy = 0.0F, yy = 0.0F, xt = 0.0F, yt = 0.0F, tt = 0.0F;

  void add(const SurfaceTerms& terms, std::size_t count) {
    SumOfTerms sum = *this;
    for (std::size_t i = 0; i < count; ++i) {
      sum.log += terms.log[i];
      sum.gx -= terms.pull_x[i];
      sum.gy -= terms.pull_y[i];
      sum.gt -= terms.pull_turn[i];
      sum.xx += terms.xx[i];
      sum.xy += terms.xy[i];
      sum.yy += terms.yy[i];
      sum.xt += terms.x_turn[i];
      sum.yt += terms.y_turn[i];
      sum.tt += terms.turn_turn[i];
    }
    *this = sum;
  }
};

double total_weight(const ScanForWeighting& scan) {
  if (scan.hit_weights.empty()) return static_cast<double>(scan.hits.size());
  return std::accumulate(scan.hit_weights.begin(), scan.hit_weights.end(), 0.0);
}

}  // namespace

ScanForWeighting scan_for_weighting(const LaserScan& scan, const HitPointOptions& points,
                                    const SurfaceLikelihoodOptions& options, double map_resolution,
                                    std::span<const float> beam_weights) {
  ScanForWeighting result;
  result.hits = hit_points(scan, points);
  result.hit_weights = hit_point_weights(scan, points, beam_weights);
  result.surface = surface_points(scan, points.max_range, kMaxGap, 0.9 * map_resolution);
  const double end = scan.max_range - options.free_before_end;
  if (scan.max_range > options.no_return_range || end <= 0.0) return result;
  const std::size_t every =
      std::max<std::size_t>(1, scan.ranges.size() / static_cast<std::size_t>(points.max_points));
  for (std::size_t beam = 0; beam < scan.ranges.size(); beam += every) {
    if (!scan.is_max_range(beam)) continue;
    if (!beam_weights.empty()) result.free_weights.push_back(beam_weights[beam]);
    result.free.push_back(scan.point_on(beam, end));
  }
  return result;
}

SurfaceLikelihood::SurfaceLikelihood(const SurfaceLikelihoodOptions& options)
    : options_(options), mixture_(options.sigma, options.inlier_ratio, kReach, kMixtureSteps) {}

double SurfaceLikelihood::sum_of_free(const ScanForWeighting& scan, const SurfaceMap& map,
                                      const Pose2& map_from_robot) const {
  const auto reach = static_cast<float>(map.resolution() * map.resolution());
  SurfaceMap::Reader reader(map);
  double sum = 0.0;
  for (std::size_t i = 0; i < scan.free.size(); ++i) {
    const Eigen::Vector2d at = map_from_robot * scan.free[i];
    const SurfaceMap::Nearest nearest = reader.nearest(at.x(), at.y());
    const float squared = nearest.off_x * nearest.off_x + nearest.off_y * nearest.off_y;
    if (!nearest.found || squared >= reach) continue;
    const double weight = scan.free_weights.empty() ? 1.0 : double{scan.free_weights[i]};
    sum += weight * mixture_.outlier_log();
  }
  return sum;
}

template <bool weighted>
double SurfaceLikelihood::sum_of_hits(const ScanForWeighting& scan, const SurfaceMap& map,
                                      const Pose2& map_from_robot) const {
  const double c = std::cos(map_from_robot.theta), s = std::sin(map_from_robot.theta);
  SurfaceMap::Reader reader(map);
  double sum = 0.0;
  for (std::size_t i = 0; i < scan.hits.size(); ++i) {
    const Eigen::Vector2d& hit = scan.hits[i];
    const SurfaceMap::Nearest nearest = reader.nearest(
        map_from_robot.x + c * hit.x() - s * hit.y(), map_from_robot.y + s * hit.x() + c * hit.y());
    const double log =
        nearest.found ? double{mixture_.log_at(squared_distance(nearest))} : mixture_.outlier_log();
    sum += weighted ? double{scan.hit_weights[i]} * log : log;
  }
  return sum;
}

double SurfaceLikelihood::sum_of_hits(const ScanForWeighting& scan, const SurfaceMap& map,
                                      const Pose2& map_from_robot) const {
  return scan.hit_weights.empty() ? sum_of_hits<false>(scan, map, map_from_robot)
                                  : sum_of_hits<true>(scan, map, map_from_robot);
}

double SurfaceLikelihood::log_likelihood(const ScanForWeighting& scan, const SurfaceMap& map,
                                         const Pose2& map_from_robot) const {
  return options_.beam_weight *
         (sum_of_hits(scan, map, map_from_robot) + sum_of_free(scan, map, map_from_robot));
}

double SurfaceLikelihood::inlier_ratio(const ScanForWeighting& scan, const SurfaceMap& map,
                                       const Pose2& map_from_robot) const {
  if (scan.hits.empty()) return 0.0;
  return mapbed::inlier_ratio(sum_of_hits(scan, map, map_from_robot),
                              total_weight(scan) * mixture_.outlier_log());
}

SurfaceLikelihood::Slope SurfaceLikelihood::slope_of_hits(const ScanForWeighting& scan,
                                                          std::size_t every, const SurfaceMap& map,
                                                          const Pose2& map_from_robot) const {
  const std::vector<Eigen::Vector2d>& hits = scan.hits;
  SurfaceMap::Reader reader(map);
  SumOfTerms sum;
  HitsOnSurface some;
  HitsOnSurface::Floats weights;
  SurfaceTerms terms;
  for (std::size_t begin = 0; begin < hits.size(); begin += every * some.count) {
    some.count = std::min(HitsOnSurface::kMost, (hits.size() - begin + every - 1) / every);
    find_surfaces(hits.data() + begin, every, map_from_robot, reader, some);
    if (!scan.hit_weights.empty()) {
      for (std::size_t k = 0; k < some.count; ++k) weights[k] = scan.hit_weights[begin + every * k];
    }
    surface_terms(some, mixture_, scan.hit_weights.empty() ? nullptr : weights.data(), terms);
    sum.add(terms, some.count);
  }
  Slope slope;
  const auto times = static_cast<double>(every);
  slope.sum = times * double{sum.log};
  const double weight = times / (options_.sigma * options_.sigma);
  slope.gradient = weight * Eigen::Vector3d(double{sum.gx}, double{sum.gy}, double{sum.gt});
  slope.information << double{sum.xx}, double{sum.xy}, double{sum.xt},  //
      double{sum.xy}, double{sum.yy}, double{sum.yt},                   //
      double{sum.xt}, double{sum.yt}, double{sum.tt};
  slope.information *= weight;
  return slope;
}

LocalPosterior SurfaceLikelihood::local_posterior(const Pose2& start, const ScanForWeighting& scan,
                                                  const SurfaceMap& map,
                                                  const PosePrior& prior) const {
  LocalPosterior result{.mode = start};
  Eigen::Matrix3d information = prior.information;
  double sum = 0.0;  // of the hits at the mode
  bool converged = false;
  for (int i = 0; i < kIterations && !converged; ++i) {
    const bool coarse = i == 0 && scan.hits.size() >= kManyHits;
    const Slope slope = slope_of_hits(scan, coarse ? kCoarse : 1, map, result.mode);
    Eigen::Matrix3d map_from_mode = Eigen::Matrix3d::Identity();  // of small steps
    const double c = std::cos(result.mode.theta), s = std::sin(result.mode.theta);
    map_from_mode.topLeftCorner<2, 2>() << c, -s, s, c;
    const Pose2 off = motion_between(prior.mean, result.mode);
    const Eigen::Vector3d pull = map_from_mode.transpose() * slope.gradient;
    const Eigen::Matrix3d of_scan = map_from_mode.transpose() * slope.information * map_from_mode;
    information = prior.information + options_.proposal_weight * of_scan;
    information.diagonal().array() += 1e-6;
    const Eigen::Vector3d step =
        information.ldlt().solve(options_.proposal_weight * pull -
                                 prior.information * Eigen::Vector3d(off.x, off.y, off.theta));
    result.mode = result.mode * Pose2{step.x(), step.y(), normalized_angle(step.z())};
    sum = slope.sum + step.dot(pull) - 0.5 * step.dot(of_scan * step);
    converged = !coarse && step.cwiseAbs().maxCoeff() < kConverged;
  }
  if (!converged) sum = sum_of_hits(scan, map, result.mode);
  result.covariance = information.inverse();
  result.log_evidence =
      options_.beam_weight * (sum + sum_of_free(scan, map, result.mode)) +
      options_.beam_weight / options_.proposal_weight *
          (prior.log_at(result.mode) + 0.5 * std::log(result.covariance.determinant()));
  return result;
}

}  // namespace mapbed
