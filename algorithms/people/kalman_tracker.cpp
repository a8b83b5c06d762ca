#include "algorithms/people/kalman_tracker.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

#include "algorithms/people/front_end/occlusion.h"
#include "core/assignment.h"

namespace mapbed {
namespace {

constexpr double kApart = 0.45;  // [m] of a new person from those who are followed

}  // namespace

void KalmanTracker::predict(double time) {
  const double seconds = has_begun_ ? std::max(0.0, time - time_) : 0.0;
  has_begun_ = true;
  time_ = time;
  for (Filter& filter : filters_) filter.state.predict(seconds, options_.acceleration);
}

// The sighting of each person, or -1.
std::vector<int> KalmanTracker::assigned(const ScanSightings& scan) const {
  Eigen::MatrixXd cost = Eigen::MatrixXd::Constant(static_cast<Eigen::Index>(filters_.size()),
                                                   static_cast<Eigen::Index>(scan.sightings.size()),
                                                   std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < filters_.size(); ++i) {
    for (std::size_t j = 0; j < scan.sightings.size(); ++j) {
      const Sighting& sighting = scan.sightings[j];
      const Eigen::Matrix2d spread = filters_[i].state.covariance.topLeftCorner<2, 2>() +
                                     sighting.sigma * sighting.sigma * Eigen::Matrix2d::Identity();
      const Eigen::Vector2d off = sighting.position - filters_[i].state.mean.head<2>();
      double away = off.dot(spread.inverse() * off);
      if (away > options_.gate * options_.gate) continue;
      const SeenBefore before = filters_[i].life.before(scan.past, sighting);
      if (before == SeenBefore::same) away += options_.place_penalty;
      if (away > options_.gate * options_.gate) continue;
      cost(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = away;
    }
  }
  return cheapest_assignment(cost);
}

void KalmanTracker::update(const ScanSightings& scan) {
  const Pose2 robot_from_local = inverse(scan.local_from_robot);
  for (Filter& filter : filters_) filter.life.recall(scan.past);
  const std::vector<int> sightings = assigned(scan);
  std::vector<bool> is_taken(scan.sightings.size(), false);
  for (std::size_t i = 0; i < filters_.size(); ++i) {
    Filter& filter = filters_[i];
    const bool is_seen = sightings[i] >= 0;
    const double hidden = hidden_probability(
        scan.view, robot_from_local * Eigen::Vector2d(filter.state.mean.head<2>()),
        options_.body_radius);
    if (is_seen) {
      const Sighting& sighting = scan.sightings[static_cast<std::size_t>(sightings[i])];
      is_taken[static_cast<std::size_t>(sightings[i])] = true;
      filter.state.correct(sighting.position, sighting.sigma);
    }
    const Sighting* sighting =
        is_seen ? &scan.sightings[static_cast<std::size_t>(sightings[i])] : nullptr;
    filter.life.update(scan, sighting, hidden, filter.state.mean.head<2>(), options_.life,
                       *learned_);
  }
  std::erase_if(filters_, [&](const Filter& filter) {
    return filter.life.is_over(scan.time(), filter.state.longest_sigma(), options_.life);
  });
  for (std::size_t j = 0; j < scan.sightings.size(); ++j) {
    const Sighting& sighting = scan.sightings[j];
    const bool is_near = std::any_of(filters_.begin(), filters_.end(), [&](const Filter& filter) {
      return filter.life.is_seen() &&
             (filter.state.mean.head<2>() - sighting.position).norm() < kApart;
    });
    if (is_taken[j] || !sighting.may_be_new() || is_near) continue;
    filters_.push_back(
        {ConstantVelocity::at(sighting.position, sighting.sigma, options_.speed_sigma),
         TrackLife(next_id_++, scan.time(), sighting.position, options_.life)});
  }
}

std::vector<FollowedPerson> KalmanTracker::people() const {
  std::vector<FollowedPerson> people;
  for (const Filter& filter : filters_) {
    people.push_back({filter.life.id(), filter.state.mean.head<2>(), filter.state.mean.tail<2>(),
                      filter.state.covariance.topLeftCorner<2, 2>(), filter.life.is_seen(),
                      filter.life.is_confirmed()});
  }
  return people;
}

double KalmanTracker::mass_near(std::size_t person, const Eigen::Vector2d& point,
                                double radius) const {
  const Filter& filter = filters_[person];
  // With the circle as a normal distribution of the same spread.
  const Eigen::Matrix2d spread = filter.state.covariance.topLeftCorner<2, 2>() +
                                 radius * radius / 4.0 * Eigen::Matrix2d::Identity();
  const Eigen::Vector2d off = point - filter.state.mean.head<2>();
  const double density =
      std::exp(-0.5 * off.dot(spread.inverse() * off)) / (2.0 * std::sqrt(spread.determinant()));
  return std::min(1.0, density * radius * radius);
}

}  // namespace mapbed
