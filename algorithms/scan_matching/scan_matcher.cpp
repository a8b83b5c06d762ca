#include "algorithms/scan_matching/scan_matcher.h"

#include <array>
#include <cmath>

#include <Eigen/Dense>

#include "algorithms/field/likelihood_slope.h"
#include "core/check.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

// The middle of the points, in metres in the robot frame.
Eigen::Vector2d middle_of(const FieldPoints& points, double resolution) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    sum += Eigen::Vector2d(double{points.x[i]}, double{points.y[i]});
  }
  return sum * (resolution / static_cast<double>(points.size()));
}

Pose2 turn_about(const Eigen::Vector2d& pivot, double turn) {
  const Eigen::Vector2d shift = pivot - Pose2{0, 0, turn} * pivot;
  return {shift.x(), shift.y(), turn};
}

// One step forth, back, left and right, and one turn each way: about the robot, as odometry errs,
// and about the middle of the points, which moves them least and so is the way along the ridge
// between turns and steps, where single steps and turns about the robot both lead down.
std::array<Pose2, 8> neighbours(const Pose2& x, double step, double turn,
                                const Eigen::Vector2d& middle) {
  return {x * Pose2{step, 0, 0},        x * Pose2{-step, 0, 0},       x * Pose2{0, step, 0},
          x * Pose2{0, -step, 0},       x * Pose2{0, 0, turn},        x * Pose2{0, 0, -turn},
          x * turn_about(middle, turn), x * turn_about(middle, -turn)};
}

// Gauss-Newton on the posterior from a pose near its optimum: the mean over all points of where
// their lines want them, which the steps of a climb, caught between cells, do not reach.
Pose2 polished(const Pose2& start, const FieldPoints& points, const LikelihoodField& map,
               const PosePrior& prediction, int iterations) {
  Pose2 x = start;
  for (int i = 0; i < iterations; ++i) {
    const Pose2 off = motion_between(prediction.mean, x);
    const Eigen::Matrix3d& information = prediction.information_at(x);
    Eigen::Matrix3d h = information + 1e-6 * Eigen::Matrix3d::Identity();
    Eigen::Vector3d g = -information * Eigen::Vector3d(off.x, off.y, off.theta);
    const LikelihoodSlope scan = likelihood_slope(points, 0, points.size(), map, x);
    h += scan.curvature;
    g += scan.slope;
    const Eigen::Vector3d step = h.ldlt().solve(g);
    x = x * Pose2{step.x(), step.y(), normalized_angle(step.z())};
  }
  return x;
}

}  // namespace

ScanMatch match_scan_from(const Pose2& start, const FieldPoints& points, const LikelihoodField& map,
                          const PosePrior& prediction, const ScanMatcherOptions& options) {
  CHECK(options.last_step > 0.0 && options.turn_per_meter > 0.0);
  if (points.size() == 0) return {.map_from_robot = prediction.mean};
  ScanMatch best{.map_from_robot = start, .points_used = static_cast<int>(points.size())};

  const auto log_posterior = [&](const Pose2& x) {
    return map.sum_log_at(points, x) + prediction.log_at(x);  // (2.19)
  };
  best.log_posterior = log_posterior(best.map_from_robot);

  const Eigen::Vector2d middle = middle_of(points, map.resolution());
  for (double step = options.first_step; step >= options.last_step;) {
    const ScanMatch before = best;
    const double turn = step * options.turn_per_meter;
    for (const Pose2& x : neighbours(before.map_from_robot, step, turn, middle)) {
      const double value = log_posterior(x);
      if (value <= best.log_posterior) continue;
      best.map_from_robot = x;
      best.log_posterior = value;
    }
    const bool improved = best.log_posterior > before.log_posterior;
    if (!improved) step /= 2.0;
  }

  const Pose2 fine =
      polished(best.map_from_robot, points, map, prediction, options.polish_iterations);
  // Along a wall that is not along the robot's axes the climb is caught on the ridge, where
  // Gauss-Newton goes far; from where it does not improve the posterior it must stay near.
  const double fine_posterior = log_posterior(fine);
  if (fine_posterior > best.log_posterior ||
      distance(fine, best.map_from_robot) <= options.last_step) {
    best.map_from_robot = fine;
    best.log_posterior = fine_posterior;
  }

  best.log_likelihood = map.sum_log_at(points, best.map_from_robot);
  best.inlier_ratio =
      inlier_ratio(best.log_likelihood, double{map.outlier_log()} * points.total_weight());
  best.trustworthy = best.inlier_ratio >= options.min_inlier_ratio;
  return best;
}

ScanMatch finer_across(const ScanMatch& match, const FieldPoints& points,
                       const LikelihoodField& map, const PosePrior& prediction,
                       const ScanMatcherOptions& options) {
  const Pose2 fine =
      polished(match.map_from_robot, points, map, prediction, options.polish_iterations);
  ScanMatch result = match;
  if (distance(fine, match.map_from_robot) <= options.last_step) result.map_from_robot = fine;
  return result;
}

ScanMatch match_scan(const FieldPoints& points, const LikelihoodField& map,
                     const PosePrior& prediction, const ScanMatcherOptions& options) {
  return match_scan_from(prediction.mean, points, map, prediction, options);
}

}  // namespace mapbed
