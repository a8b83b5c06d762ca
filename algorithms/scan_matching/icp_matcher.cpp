#include "algorithms/scan_matching/icp_matcher.h"

#include <cmath>
#include <utility>

#include <Eigen/Dense>
#include <nanoflann.hpp>

#include "core/check.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

struct Cloud {
  std::vector<IcpMap::Pair> pairs;

  std::size_t kdtree_get_point_count() const { return pairs.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const {
    return pairs[i].point[static_cast<Eigen::Index>(axis)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

using Index =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, 2>;

}  // namespace

struct IcpMap::Tree {
  Cloud cloud;
  Index index{2, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(10)};
};

IcpMap::~IcpMap() = default;
IcpMap::IcpMap(IcpMap&&) noexcept = default;
IcpMap& IcpMap::operator=(IcpMap&&) noexcept = default;

IcpMap::IcpMap(const std::vector<SurfacePoint>& points_in_map) : tree_(std::make_unique<Tree>()) {
  for (const SurfacePoint& point : points_in_map) {
    const Eigen::Vector2d along = tangent_of(point.doubled);
    tree_->cloud.pairs.push_back({point.position, {-along.y(), along.x()}});
  }
  tree_->index.buildIndex();
}

const IcpMap::Pair* IcpMap::nearest(const Eigen::Vector2d& point, double max_distance) const {
  if (tree_->cloud.pairs.empty()) return nullptr;
  std::uint32_t index = 0;
  double squared = 0.0;
  tree_->index.knnSearch(point.data(), 1, &index, &squared);
  return squared <= max_distance * max_distance ? &tree_->cloud.pairs[index] : nullptr;
}

ScanMatch match_icp(const std::vector<Eigen::Vector2d>& points_in_robot, const IcpMap& map,
                    const PosePrior& prediction, const IcpMatcherOptions& options,
                    std::span<const float> weights) {
  CHECK(options.max_iterations > 0 && options.sigma > 0.0);
  CHECK(weights.empty() || weights.size() == points_in_robot.size());
  ScanMatch match{.map_from_robot = prediction.mean,
                  .points_used = static_cast<int>(points_in_robot.size())};
  if (points_in_robot.empty()) return match;

  for (int iteration = 0; iteration < options.max_iterations; ++iteration) {
    // Gauss-Newton on a step in the robot's frame: x, y, theta.
    Eigen::Matrix3d h = prediction.information_at(match.map_from_robot);
    const Pose2 off = motion_between(prediction.mean, match.map_from_robot);
    Eigen::Vector3d g = h * Eigen::Vector3d(off.x, off.y, off.theta);
    const double c = std::cos(match.map_from_robot.theta), s = std::sin(match.map_from_robot.theta);
    double paired = 0.0, all = 0.0;  // weights
    double cost = 0.0;
    for (std::size_t i = 0; i < points_in_robot.size(); ++i) {
      const Eigen::Vector2d& p = points_in_robot[i];
      const double own_weight = weights.empty() ? 1.0 : double{weights[i]};
      all += own_weight;
      const Eigen::Vector2d point = match.map_from_robot * p;
      const IcpMap::Pair* pair = map.nearest(point, options.max_distance);
      if (pair == nullptr) continue;
      paired += own_weight;
      // To the line, or where the map knows none to the point, which the error's own direction
      // does.
      const Eigen::Vector2d error = point - pair->point;
      const Eigen::Vector2d across = pair->normal.isZero() ? error.normalized() : pair->normal;
      const double residual = across.dot(error) / options.sigma;
      const double weight = own_weight / (1.0 + residual * residual);  // Cauchy
      const Eigen::Vector2d normal(c * across.x() + s * across.y(),
                                   -s * across.x() + c * across.y());  // in the robot frame
      const Eigen::Vector3d gradient =
          Eigen::Vector3d(normal.x(), normal.y(), p.x() * normal.y() - p.y() * normal.x()) /
          options.sigma;
      h += weight * gradient * gradient.transpose();
      g += weight * residual * gradient;
      cost += own_weight * (0.5 * std::log1p(residual * residual));
    }
    match.inlier_ratio = paired / all;
    match.log_likelihood = -cost;
    match.log_posterior = -cost + prediction.log_at(match.map_from_robot);
    const Eigen::Vector3d step = (h + 1e-9 * Eigen::Matrix3d::Identity()).ldlt().solve(-g);
    match.map_from_robot =
        match.map_from_robot * Pose2{step.x(), step.y(), normalized_angle(step.z())};
    if (step.cwiseAbs().maxCoeff() < options.last_step) break;
  }
  match.trustworthy = match.inlier_ratio >= options.min_paired;
  return match;
}

}  // namespace mapbed
