#pragma once

#include <memory>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "algorithms/motion/pose_prior.h"
#include "algorithms/scan/surface_points.h"
#include "algorithms/scan_matching/scan_matcher.h"
#include "core/config/option.h"

namespace mapbed {

// Point-to-line ICP (Censi 2008), the second baseline: each point is paired with the nearest point
// of the local map, and the sum of squared distances to the lines through those points (to the
// points themselves where the map knows no line), with the
// prior, is minimised by Gauss-Newton; pairs far from the line count less (Cauchy).
struct IcpMatcherOptions {
  int max_iterations = 30;
  double max_distance = 0.5;  // [m] of a pair
  double sigma = 0.03;        // [m] of the distance between a point and its line
  double last_step = 0.0005;  // [m] and [rad] stop when a step is smaller
  double min_paired = 0.5;    // a match that pairs a smaller fraction of the points is not trusted
};

template <class Visitor>
void visit_fields(IcpMatcherOptions& o, Visitor&& visit) {
  visit("max_iterations", o.max_iterations, between(1, 1000), "iterations at most");
  visit("max_distance", o.max_distance, Unit::meter, between(0.001, 100.0),
        "between the points of a pair");
  visit("sigma", o.sigma, Unit::meter, between(1e-4, 10.0), "sigma of points about their lines");
  visit("last_step", o.last_step, Unit::meter, between(1e-9, 1.0),
        "the iteration ends with a smaller step [m, rad]");
  visit("min_paired", o.min_paired, kFraction, "fraction of the points that a trusted match pairs");
}

// Map points with the normals of the lines through them, and a tree to find the nearest.
class IcpMap {
 public:
  explicit IcpMap(const std::vector<SurfacePoint>& points_in_map);
  ~IcpMap();
  IcpMap(IcpMap&&) noexcept;
  IcpMap& operator=(IcpMap&&) noexcept;

  struct Pair {
    Eigen::Vector2d point;
    Eigen::Vector2d normal;  // of unit length; zero where no line is known
  };
  // The nearest map point not farther than max_distance [m]; null where there is none.
  const Pair* nearest(const Eigen::Vector2d& point, double max_distance) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

// log_posterior and inlier_ratio (fraction of paired points) are ICP's own and do not compare with
// those of the likelihood field.
ScanMatch match_icp(const std::vector<Eigen::Vector2d>& points_in_robot, const IcpMap& map,
                    const PosePrior& prediction, const IcpMatcherOptions& options = {},
                    std::span<const float> weights = {});

}  // namespace mapbed
