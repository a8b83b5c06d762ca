#include "sim/actors/itinerary.h"

#include <cmath>

#include "core/check.h"

namespace mapbed {
namespace {

constexpr double kArrived = 0.6;    // [m]
constexpr double kLookEvery = 0.3;  // [s]
constexpr double kProgress = 0.8;   // [m] who gets this far gets on
constexpr double kPatience = 4.0;   // [s] without getting on, then tries another way
constexpr int kVainPlans = 2;       // then turn back
constexpr double kScatter = 0.35;   // [m] nobody walks exactly where others do

}  // namespace

Itinerary::Itinerary(const CrowdRoute& route, const CrowdRules& rules, std::size_t next,
                     int direction, Rng rng)
    : points_(route.points),
      closed_(route.closed),
      pause_fraction_(rules.pause_fraction),
      mean_pause_(rules.mean_pause),
      next_(next),
      direction_(direction),
      rng_(rng) {
  CHECK(points_.size() >= 2 && next < points_.size());
}

// Somebody or something stands in the way for good.
void Itinerary::turn_back() {
  const std::size_t count = points_.size();
  direction_ = -direction_;
  vain_plans_ = 0;
  if (closed_) {
    next_ = direction_ > 0 ? (next_ + 1) % count : (next_ + count - 1) % count;
  } else if (direction_ > 0 ? next_ + 1 < count : next_ > 0) {
    next_ = direction_ > 0 ? next_ + 1 : next_ - 1;
  }
}

void Itinerary::arrive(double time) {
  if (rng_.uniform() < pause_fraction_)
    pause_until_ = time - mean_pause_ * std::log(1.0 - rng_.uniform());
  const std::size_t count = points_.size();
  if (closed_) {
    next_ = direction_ > 0 ? (next_ + 1) % count : (next_ + count - 1) % count;
  } else {
    if (direction_ > 0 && next_ + 1 == count) direction_ = -1;
    if (direction_ < 0 && next_ == 0) direction_ = 1;
    next_ = direction_ > 0 ? next_ + 1 : next_ - 1;
  }
  corners_.clear();
}

void Itinerary::plan_way(const Eigen::Vector2d& position, double radius, const NavigationMap& map) {
  goal_ = points_[next_];
  for (int attempt = 0; attempt < 8; ++attempt) {
    const Eigen::Vector2d near =
        points_[next_] + kScatter * Eigen::Vector2d(rng_.normal(), rng_.normal());
    if (!map.is_straight_way(points_[next_], near, radius)) continue;
    goal_ = near;
    break;
  }
  const auto way = map.way(position, goal_, radius);
  corners_ = way ? *way : std::vector<Eigen::Vector2d>{position, goal_};
  corner_ = 1;
}

Eigen::Vector2d Itinerary::wish(const Eigen::Vector2d& position, double speed, double radius,
                                const NavigationMap& map, double time) {
  if (is_pausing(time)) {
    anchored_at_ = time;
    return Eigen::Vector2d::Zero();
  }
  if (corners_.empty()) plan_way(position, radius, map);
  if ((goal_ - position).norm() < kArrived) {
    arrive(time);
    if (is_pausing(time)) return Eigen::Vector2d::Zero();
    plan_way(position, radius, map);
  }
  if ((position - anchor_).norm() > kProgress) {
    anchor_ = position;
    anchored_at_ = time;
    vain_plans_ = 0;
  }
  if (time - anchored_at_ > kPatience) {
    if (++vain_plans_ >= kVainPlans) turn_back();
    plan_way(position, radius, map);
    anchored_at_ = time;
  }
  if (time >= next_look_) {
    next_look_ = time + kLookEvery;
    while (corner_ + 1 < corners_.size() &&
           map.is_straight_way(position, corners_[corner_ + 1], radius)) {
      ++corner_;
    }
  }
  const Eigen::Vector2d to_go = corners_[corner_] - position;
  const double d = to_go.norm();
  if (d < 0.3 && corner_ + 1 < corners_.size()) ++corner_;
  return d > 1e-9 ? Eigen::Vector2d(speed / d * to_go) : Eigen::Vector2d::Zero();
}

}  // namespace mapbed
