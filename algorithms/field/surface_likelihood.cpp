#include "algorithms/field/surface_likelihood.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Dense>

#include "algorithms/field/surface_map_reader.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

constexpr double kMaxGap = 0.2;  // [m] neighbouring hits that are nearer belong to one surface
constexpr int kIterations = 4;
constexpr std::size_t kCoarse = 3;     // the first step is taken by every third hit
constexpr std::size_t kManyHits = 40;  // of fewer by all
constexpr double kConverged = 2e-3;    // [m], [rad] the step after that is far smaller still
constexpr float kAlong = 0.1F;  // of a distance along a mapped line that counts, as in the field
constexpr float kMinAgreement = 0.5F;  // of the directions that make a line, as in tangent_of
constexpr int kMixtureSteps = 512;
constexpr double kReach = 4.0;  // [sigma] beyond, the Gaussian counts for nothing

// The projection on the line of a mapped point, (I + [x y; y -x]) / 2 with (x, y) = (cos 2a, sin
// 2a); nothing where it has no line.
struct Projection {
  float half = 0.0F;         // 1/2, or 0
  float x = 0.0F, y = 0.0F;  // times 1/2

  explicit Projection(const SurfaceMap::Nearest& nearest) {
    const float squared =
        nearest.doubled_x * nearest.doubled_x + nearest.doubled_y * nearest.doubled_y;
    if (squared < kMinAgreement * kMinAgreement) return;
    half = 0.5F;
    const float scale = 0.5F / std::sqrt(squared);
    x = scale * nearest.doubled_x;
    y = scale * nearest.doubled_y;
  }
};

// Of a point to the mapped surface [m^2].
float squared_distance(const SurfaceMap::Nearest& nearest, const Projection& along) {
  const float xx = nearest.off_x * nearest.off_x, yy = nearest.off_y * nearest.off_y;
  const float squared_along =
      along.half * (xx + yy) + along.x * (xx - yy) + 2.0F * along.y * nearest.off_x * nearest.off_y;
  return xx + yy - (1.0F - kAlong * kAlong) * squared_along;
}

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
    const double log = nearest.found
                           ? double{mixture_.log_at(squared_distance(nearest, Projection(nearest)))}
                           : mixture_.outlier_log();
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

template <bool weighted>
SurfaceLikelihood::Slope SurfaceLikelihood::slope_of_hits(const ScanForWeighting& scan,
                                                          std::size_t every, const SurfaceMap& map,
                                                          const Pose2& map_from_robot) const {
  const std::vector<Eigen::Vector2d>& hits = scan.hits;
  const double c = std::cos(map_from_robot.theta), s = std::sin(map_from_robot.theta);
  SurfaceMap::Reader reader(map);
  float sum = 0.0F, gx = 0.0F, gy = 0.0F, gt = 0.0F;
  float xx = 0.0F, xy = 0.0F, yy = 0.0F, xt = 0.0F, yt = 0.0F, tt = 0.0F;
  for (std::size_t i = 0; i < hits.size(); i += every) {
    const double x = c * hits[i].x() - s * hits[i].y(), y = s * hits[i].x() + c * hits[i].y();
    const SurfaceMap::Nearest nearest = reader.nearest(map_from_robot.x + x, map_from_robot.y + y);
    if (!nearest.found) {
      const auto log = static_cast<float>(mixture_.outlier_log());
      sum += weighted ? scan.hit_weights[i] * log : log;
      continue;
    }
    const Projection along(nearest);
    HitMixture::Value value = mixture_.at(squared_distance(nearest, along));
    if constexpr (weighted) {
      value.log *= scan.hit_weights[i];
      value.inlier *= scan.hit_weights[i];
    }
    sum += value.log;
    // Along its line a point may slide: it pulls across it only.
    const float nxx = value.inlier * (1.0F - along.half - along.x);
    const float nxy = -value.inlier * along.y;
    const float nyy = value.inlier * (1.0F - along.half + along.x);
    const float pull_x = nxx * nearest.off_x + nxy * nearest.off_y;
    const float pull_y = nxy * nearest.off_x + nyy * nearest.off_y;
    // A turn moves the point by (-dy, dx).
    const auto dx = static_cast<float>(x), dy = static_cast<float>(y);
    const float mx = dx * nxy - dy * nxx, my = dx * nyy - dy * nxy;
    gx -= pull_x;
    gy -= pull_y;
    gt -= dx * pull_y - dy * pull_x;
    xx += nxx;
    xy += nxy;
    yy += nyy;
    xt += mx;
    yt += my;
    tt += dx * my - dy * mx;
  }
  Slope slope;
  const auto times = static_cast<double>(every);
  slope.sum = times * double{sum};
  const double weight = times / (options_.sigma * options_.sigma);
  slope.gradient = weight * Eigen::Vector3d(double{gx}, double{gy}, double{gt});
  slope.information << double{xx}, double{xy}, double{xt},  //
      double{xy}, double{yy}, double{yt},                   //
      double{xt}, double{yt}, double{tt};
  slope.information *= weight;
  return slope;
}

SurfaceLikelihood::Slope SurfaceLikelihood::slope_of_hits(const ScanForWeighting& scan,
                                                          std::size_t every, const SurfaceMap& map,
                                                          const Pose2& map_from_robot) const {
  return scan.hit_weights.empty() ? slope_of_hits<false>(scan, every, map, map_from_robot)
                                  : slope_of_hits<true>(scan, every, map, map_from_robot);
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
