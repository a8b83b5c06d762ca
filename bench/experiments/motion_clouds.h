#pragma once

#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "algorithms/motion/motion_learning.h"
#include "bench/results/result_file.h"
#include "core/geometry/pose2.h"
#include "core/random.h"

namespace mapbed {

// Samples of where the robot may be after each of some moves, by the error model of its motion,
// section 5.3.
using MotionClouds = std::vector<std::vector<Pose2>>;

MotionClouds clouds_of(std::span<const MotionSample> moves, const MotionModelOptions& model,
                       int samples, Rng rng);

// In which 95 % of a normal distribution of x and y lie.
struct Ellipse {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  Eigen::Matrix2d root = Eigen::Matrix2d::Zero();  // of the covariance
  static constexpr double kRadius = 2.447746831;   // sqrt of chi-squared with 2 freedoms at 95 %

  double area() const;  // [m^2]
};

Ellipse ellipse_of(const std::vector<Pose2>& cloud);

// The clouds of the same moves by odometry and by scan matching. `label` tells which run it is.
std::vector<ResultFile> clouds_figure(std::span<const MotionSample> moves,
                                      const MotionClouds& odometry, const MotionClouds& matching,
                                      const std::string& label);

}  // namespace mapbed
