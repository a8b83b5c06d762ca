#include "algorithms/people/person_particles.h"

#include <cmath>
#include <numbers>

#include "algorithms/particles/resampling.h"
#include "core/check.h"

namespace mapbed {
namespace {

// The variance of a kernel about each of n samples in the plane, of theirs (Silverman, 1986).
double kernel_share(std::size_t count) {
  return std::pow(static_cast<double>(count), -1.0 / 3.0);
}

}  // namespace

PersonParticles::PersonParticles(std::size_t count, const Eigen::Vector2d& position, double sigma,
                                 const PersonMotionOptions& motion, Rng rng)
    : motion_(motion) {
  CHECK(count > 0);
  states_.reserve(count);
  for (std::size_t n = 0; n < count; ++n) {
    const double x = rng.normal(position.x(), sigma);
    const double y = rng.normal(position.y(), sigma);
    const double vx = rng.normal(0.0, motion.speed_sigma);
    const double vy = rng.normal(0.0, motion.speed_sigma);
    states_.emplace_back(x, y, vx, vy);
  }
  summarize();
}

void PersonParticles::predict(double seconds, Rng rng) {
  if (seconds <= 0.0) return;
  const double change = 1.0 - std::exp(-motion_.change_rate * seconds);
  const double sigma = motion_.acceleration * std::sqrt(seconds);
  for (Eigen::Vector4d& h : states_) {
    Eigen::Vector2d v = h.tail<2>();
    const Eigen::Vector2d before = v;
    if (rng.uniform() < change) {
      const bool stops = rng.uniform() < motion_.stop_fraction;
      const double speed = stops ? 0.0 : motion_.speed_sigma;
      v.x() = rng.normal(0.0, speed);
      v.y() = rng.normal(0.0, speed);
    }
    v.x() += rng.normal(0.0, sigma);
    v.y() += rng.normal(0.0, sigma);
    if (v.norm() > motion_.top_speed) v *= motion_.top_speed / v.norm();
    h.head<2>() += 0.5 * seconds * (before + v);
    h.tail<2>() = v;
  }
  summarize();
}

std::vector<double> PersonParticles::likelihoods(const Eigen::Vector2d& feature,
                                                 double sigma) const {
  const double variance = sigma * sigma + kernel_share(size()) * covariance_.trace() / 2.0;
  const double peak = 1.0 / (2.0 * std::numbers::pi * variance);
  std::vector<double> result;
  result.reserve(size());
  for (const Eigen::Vector4d& h : states_) {
    result.push_back(peak * std::exp(-0.5 * (h.head<2>() - feature).squaredNorm() / variance));
  }
  return result;
}

void PersonParticles::resample(const std::vector<double>& weights, Rng rng) {
  std::vector<Eigen::Vector4d> drawn;
  drawn.reserve(size());
  for (const std::size_t n : resampled(weights, rng)) drawn.push_back(states_[n]);
  states_ = std::move(drawn);
  summarize();
}

double PersonParticles::spread() const {
  const double half = covariance_.trace() / 2.0;
  const double difference = (covariance_(0, 0) - covariance_(1, 1)) / 2.0;
  return std::sqrt(half + std::hypot(difference, covariance_(0, 1)));
}

double PersonParticles::mass_near(const Eigen::Vector2d& point, double radius) const {
  std::size_t near = 0;
  for (const Eigen::Vector4d& h : states_) {
    if ((h.head<2>() - point).squaredNorm() <= radius * radius) ++near;
  }
  return static_cast<double>(near) / static_cast<double>(size());
}

void PersonParticles::summarize() {
  const auto count = static_cast<double>(size());
  mean_.setZero();
  for (const Eigen::Vector4d& h : states_) mean_ += h;
  mean_ /= count;
  covariance_.setZero();
  for (const Eigen::Vector4d& h : states_) {
    const Eigen::Vector2d off = h.head<2>() - mean_.head<2>();
    covariance_ += off * off.transpose();
  }
  covariance_ /= count;
}

}  // namespace mapbed
