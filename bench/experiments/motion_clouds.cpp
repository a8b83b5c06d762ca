#include "bench/experiments/motion_clouds.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "bench/plot/plot.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

PlotSeries dots_of(const std::string& name, const MotionClouds& clouds) {
  constexpr std::size_t kDrawn = 150;  // of each cloud
  PlotSeries series{.name = name, .mark = Mark::dots};
  for (const std::vector<Pose2>& cloud : clouds) {
    for (std::size_t i = 0; i < std::min(kDrawn, cloud.size()); ++i) {
      series.x.push_back(cloud[i].x);
      series.y.push_back(cloud[i].y);
    }
  }
  return series;
}

PlotSeries outline_of(const std::string& name, const Ellipse& ellipse, int like) {
  PlotSeries series{.name = name, .mark = Mark::path, .like = like};
  for (int i = 0; i <= 72; ++i) {
    const double angle = radians(5.0 * i);
    const Eigen::Vector2d point =
        ellipse.center +
        Ellipse::kRadius * ellipse.root * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    series.x.push_back(point.x());
    series.y.push_back(point.y());
  }
  return series;
}

PlotSeries true_path(std::span<const MotionSample> moves) {
  PlotSeries series{.name = "true path", .x = {0.0}, .y = {0.0}};
  Pose2 pose;
  for (const MotionSample& move : moves) {
    pose = pose * move.reference;
    series.x.push_back(pose.x);
    series.y.push_back(pose.y);
  }
  return series;
}

}  // namespace

MotionClouds clouds_of(std::span<const MotionSample> moves, const MotionModelOptions& model,
                       int samples, Rng rng) {
  MotionClouds clouds;
  std::vector<Pose2> cloud(static_cast<std::size_t>(samples));
  for (const MotionSample& move : moves) {
    for (Pose2& pose : cloud) pose = pose * sampled_motion(move.measured, model, rng);
    clouds.push_back(cloud);
  }
  return clouds;
}

double Ellipse::area() const {
  return kPi * kRadius * kRadius * std::abs(root.determinant());
}

Ellipse ellipse_of(const std::vector<Pose2>& cloud) {
  Ellipse ellipse;
  const auto n = static_cast<double>(cloud.size());
  for (const Pose2& pose : cloud) ellipse.center += pose.position() / n;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  for (const Pose2& pose : cloud) {
    const Eigen::Vector2d off = pose.position() - ellipse.center;
    covariance += off * off.transpose() / n;
  }
  ellipse.root = covariance.llt().matrixL();
  return ellipse;
}

std::vector<ResultFile> clouds_figure(std::span<const MotionSample> moves,
                                      const MotionClouds& odometry, const MotionClouds& matching,
                                      const std::string& label) {
  Plot plot{.title = fmt::format("Where the robot may be after each of {} moves", moves.size()),
            .subtitle = (label.empty() ? "" : label + "; ") +
                        "those of the median ratio of areas; 150 samples of each, by the models "
                        "learned from the other half of the drive; ellipses: 95 % after the last "
                        "move; beside Figure 5.3",
            .x = {"x, the robot looks along it at the start", "m"},
            .y = {"y", "m"},
            .equal_scales = true};
  plot.series = {dots_of("raw odometry", odometry), dots_of("scan matching", matching),
                 outline_of("", ellipse_of(odometry.back()), 0),
                 outline_of("", ellipse_of(matching.back()), 1), true_path(moves)};
  return {{"figures/clouds.svg", svg_of(plot)}, {"figures/clouds.csv", csv_of(plot)}};
}

}  // namespace mapbed
