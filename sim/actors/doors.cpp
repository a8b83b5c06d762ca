#include "sim/actors/doors.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

constexpr double kShutsAfter = 2.0;   // [s] that nobody has been near
constexpr double kLeafMargin = 0.08;  // [m] kept between leaf and visitors
constexpr double kNever = std::numeric_limits<double>::infinity();

double exponential(double mean, Rng& rng) {
  return mean > 0.0 ? -mean * std::log(1.0 - rng.uniform()) : kNever;
}

Wall leaf_wall(const Door& door, double angle) {
  const Pose2 leaf = door.world_from_hinge * Pose2{0.0, 0.0, angle};
  return {leaf.position(), leaf * Eigen::Vector2d(door.width, 0.0), 0.0};
}

// Would the leaf, here or a little further on, touch one of them?
bool is_blocked(const Door& door, double angle, std::span<const DoorVisitor> visitors) {
  const Wall leaf = leaf_wall(door, angle);
  return std::any_of(visitors.begin(), visitors.end(), [&](const DoorVisitor& visitor) {
    const double d = (nearest_point(leaf, visitor.position) - visitor.position).norm();
    return d < visitor.radius + kLeafMargin;
  });
}

bool is_anyone_near(const Door& door, std::span<const DoorVisitor> visitors) {
  const Eigen::Vector2d middle = door.world_from_hinge * Eigen::Vector2d(door.width / 2.0, 0.0);
  return std::any_of(visitors.begin(), visitors.end(), [&](const DoorVisitor& visitor) {
    return (visitor.position - middle).norm() - visitor.radius < door.opens_within;
  });
}

}  // namespace

Doors::Doors(const World& world, const Rng& rng) {
  for (std::size_t i = 0; i < world.doors.size(); ++i) {
    const Door& door = world.doors[i];
    State state{.door = door,
                .rng = rng.stream("door", i),
                .angle = door.starts_open ? door.open_angle : 0.0,
                .wants_open = door.starts_open,
                .change_at = kNever};
    state.change_at = exponential(door.starts_open ? door.mean_open : door.mean_shut, state.rng);
    doors_.push_back(std::move(state));
  }
  update_walls();
}

void Doors::decide(State& s, std::span<const DoorVisitor> visitors) const {
  if (time_ >= s.change_at) {
    s.wants_open = !s.wants_open;
    s.change_at = time_ + exponential(s.wants_open ? s.door.mean_open : s.door.mean_shut, s.rng);
  }
  if (s.door.opens_within <= 0.0 || !is_anyone_near(s.door, visitors)) return;
  if (!s.wants_open) s.wants_open = true;
  const double stay = s.door.mean_open > 0.0 ? exponential(s.door.mean_open, s.rng) : kShutsAfter;
  if (!s.door.starts_open) s.change_at = time_ + stay;
}

void Doors::step(std::span<const DoorVisitor> visitors, double dt) {
  time_ += dt;
  for (State& s : doors_) {
    decide(s, visitors);
    const double target = s.wants_open ? s.door.open_angle : 0.0;
    const double step =
        std::clamp(target - s.angle, -s.door.turn_speed * dt, s.door.turn_speed * dt);
    s.is_moving = step != 0.0 && !is_blocked(s.door, s.angle + step, visitors);
    if (s.is_moving) s.angle += step;
  }
  update_walls();
}

Pose2 Doors::world_from_leaf(std::size_t index) const {
  return doors_[index].door.world_from_hinge * Pose2{0.0, 0.0, doors_[index].angle};
}

void Doors::update_walls() {
  walls_.clear();
  for (const State& s : doors_) walls_.push_back(leaf_wall(s.door, s.angle));
}

}  // namespace mapbed
