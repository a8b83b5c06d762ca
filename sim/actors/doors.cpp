#include "sim/actors/doors.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/angle.h"
#include "sim/actors/navigation_map.h"

namespace mapbed {
namespace {

constexpr double kShutsAfter = 2.0;      // [s] that nobody has been near
constexpr double kLeafThickness = 0.04;  // [m]
constexpr double kLeafMargin = 0.08;     // [m] kept between leaf and visitors
constexpr double kNever = std::numeric_limits<double>::infinity();

double exponential(double mean, Rng& rng) {
  return mean > 0.0 ? -mean * std::log(1.0 - rng.uniform()) : kNever;
}

// The robot or somebody of whom it holds.
template <class Holds>
bool any_visitor(const SimState& state, Holds holds) {
  return holds(state.robot) ||
         std::any_of(state.obstacles.begin(), state.obstacles.end(),
                     [&](const Obstacle& o) { return o.is_disc() && holds(o); });
}

// Would the leaf, here or a little further on, touch one of them?
bool is_blocked(const Door& door, double angle, const SimState& state) {
  const Pose2 leaf_pose = door.world_from_hinge * Pose2{0.0, 0.0, angle};
  const Wall leaf{leaf_pose.position(), leaf_pose * Eigen::Vector2d(door.width, 0.0), 0.0};
  return any_visitor(state, [&](const Obstacle& visitor) {
    const Eigen::Vector2d position = visitor.pose.position();
    return (nearest_point(leaf, position) - position).norm() < visitor.radius + kLeafMargin;
  });
}

bool is_anyone_near(const Door& door, const SimState& state) {
  const Eigen::Vector2d middle = door.world_from_hinge * Eigen::Vector2d(door.width / 2.0, 0.0);
  return any_visitor(state, [&](const Obstacle& visitor) {
    return (visitor.pose.position() - middle).norm() - visitor.radius < door.opens_within;
  });
}

// Nothing can move it.
bool is_fixed(const Door& door) {
  return door.opens_within <= 0.0 && door.mean_open <= 0.0 && door.mean_shut <= 0.0;
}

}  // namespace

Doors::Doors(const World& world, const Rng& rng) {
  for (std::size_t i = 0; i < world.doors.size(); ++i) {
    const Door& door = world.doors[i];
    State state{.door = door,
                .leaf_from_part = {},
                .rng = rng.stream("door", i),
                .angle = door.starts_open ? door.open_angle : 0.0,
                .wants_open = door.starts_open,
                .change_at = kNever};
    state.change_at = exponential(door.starts_open ? door.mean_open : door.mean_shut, state.rng);
    for (const Part& part : world.entities[static_cast<std::size_t>(door.entity)].parts) {
      state.leaf_from_part.push_back(part.entity_from_part);
    }
    doors_.push_back(std::move(state));
  }
}

void Doors::decide(State& s, const SimState& state) const {
  if (time_ >= s.change_at) {
    s.wants_open = !s.wants_open;
    s.change_at = time_ + exponential(s.wants_open ? s.door.mean_open : s.door.mean_shut, s.rng);
  }
  if (s.door.opens_within <= 0.0 || !is_anyone_near(s.door, state)) return;
  if (!s.wants_open) s.wants_open = true;
  const double stay = s.door.mean_open > 0.0 ? exponential(s.door.mean_open, s.rng) : kShutsAfter;
  if (!s.door.starts_open) s.change_at = time_ + stay;
}

void Doors::step(double dt, const SimState& state) {
  time_ += dt;
  for (State& s : doors_) {
    decide(s, state);
    const double target = s.wants_open ? s.door.open_angle : 0.0;
    const double step =
        std::clamp(target - s.angle, -s.door.turn_speed * dt, s.door.turn_speed * dt);
    s.is_moving = step != 0.0 && !is_blocked(s.door, s.angle + step, state);
    if (s.is_moving) s.angle += step;
  }
}

Pose2 Doors::world_from_leaf(std::size_t index) const {
  return doors_[index].door.world_from_hinge * Pose2{0.0, 0.0, doors_[index].angle};
}

void Doors::append_obstacles(std::vector<Obstacle>& obstacles) const {
  for (std::size_t i = 0; i < doors_.size(); ++i) {
    obstacles.push_back(
        {.pose = world_from_leaf(i), .length = doors_[i].door.width, .thickness = kLeafThickness});
  }
}

void Doors::append_poses(std::vector<MovingPose>& poses) const {
  for (std::size_t i = 0; i < doors_.size(); ++i) {
    const State& s = doors_[i];
    const Motion motion = is_fixed(s.door) ? Motion::still
                          : s.is_moving    ? Motion::moving
                                           : Motion::waiting;
    const Pose3 leaf = upright(world_from_leaf(i));
    for (std::size_t part = 0; part < s.leaf_from_part.size(); ++part) {
      poses.push_back(
          {s.door.entity, static_cast<int>(part), leaf * s.leaf_from_part[part], motion});
    }
  }
}

}  // namespace mapbed
