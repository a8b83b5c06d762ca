#include "sim/actors/movables.h"

#include <algorithm>
#include <cmath>

#include "worlds/geometry/footprint.h"

namespace mapbed {
namespace {

constexpr double kMargin = 0.1;  // [m] kept from who is in the way

double exponential(double mean, Rng& rng) {
  return -mean * std::log(1.0 - rng.uniform());
}

// Of the circle about the entity's origin that holds all of its parts.
double radius_of(const Entity& entity) {
  World alone;
  alone.entities = {entity};
  alone.entities.front().world_from_entity = {};
  const Eigen::AlignedBox3d bounds = bounds_of(alone);
  return std::hypot(std::max(-bounds.min().x(), bounds.max().x()),
                    std::max(-bounds.min().y(), bounds.max().y()));
}

}  // namespace

Movables::Movables(const World& world, int first_entity, const Rng& rng)
    : first_entity_(first_entity) {
  for (std::size_t i = 0; i < world.movables.size(); ++i) {
    const Movable& movable = world.movables[i];
    State state{.movable = movable,
                .rng = rng.stream("movable", i),
                .radius = radius_of(movable.entity),
                .position = movable.entity.world_from_entity.position.head<2>()};
    state.rests_until = exponential(movable.mean_rest, state.rng);
    movables_.push_back(std::move(state));
  }
}

Pose3 Movables::world_from_entity(const State& state) const {
  Pose3 pose = state.movable.entity.world_from_entity;
  pose.position.head<2>() = state.position;
  return pose;
}

std::vector<Entity> Movables::entities() const {
  std::vector<Entity> entities;
  for (const State& state : movables_) entities.push_back(state.movable.entity);
  return entities;
}

void Movables::step(double dt, const SimState& state) {
  time_ += dt;
  for (State& s : movables_) {
    const std::vector<Eigen::Vector2d>& places = s.movable.places;
    s.velocity.setZero();
    if (places.size() < 2 || time_ < s.rests_until) continue;
    const Eigen::Vector2d to_go = places[s.next] - s.position;
    const double step = std::min(s.movable.speed * dt, to_go.norm());
    const Eigen::Vector2d motion =
        to_go.norm() > 0.0 ? Eigen::Vector2d(step / to_go.norm() * to_go) : Eigen::Vector2d::Zero();
    const auto is_in_the_way = [&](const Obstacle& other) {
      const Eigen::Vector2d off = other.pose.position() - s.position;
      // Not itself, which is among the obstacles; nor what it moves away from.
      return other.is_disc() && off.norm() > 1e-9 && off.dot(motion) > 0.0 &&
             (off - motion).norm() < other.radius + s.radius + kMargin;
    };
    if (is_in_the_way(state.robot) ||
        std::any_of(state.obstacles.begin(), state.obstacles.end(), is_in_the_way)) {
      continue;
    }
    s.position += motion;
    s.velocity = motion / dt;
    if (s.position != places[s.next] && step < to_go.norm()) continue;
    s.position = places[s.next];
    s.next = (s.next + 1) % places.size();
    s.rests_until = time_ + exponential(s.movable.mean_rest, s.rng);
  }
}

void Movables::append_obstacles(std::vector<Obstacle>& obstacles) const {
  for (const State& s : movables_) {
    obstacles.push_back({.pose = {s.position.x(), s.position.y(), 0.0},
                         .velocity = s.velocity,
                         .radius = s.radius});
  }
}

void Movables::append_poses(std::vector<MovingPose>& poses) const {
  for (std::size_t i = 0; i < movables_.size(); ++i) {
    const State& s = movables_[i];
    const Motion motion = s.movable.places.size() < 2 ? Motion::still
                          : s.velocity.norm() > 0.0   ? Motion::moving
                                                      : Motion::waiting;
    const Pose3 pose = world_from_entity(s);
    int part = 0;
    for (const Part& piece : s.movable.entity.parts) {
      poses.push_back(
          {first_entity_ + static_cast<int>(i), part++, pose * piece.entity_from_part, motion});
    }
  }
}

}  // namespace mapbed
