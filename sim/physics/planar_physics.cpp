#include "sim/physics/planar_physics.h"

#include <cmath>
#include <vector>

#include <box2d/box2d.h>

#include "core/check.h"
#include "core/geometry/angle.h"
#include "worlds/geometry/footprint.h"

namespace mapbed {
namespace {

constexpr int kVelocityIterations = 8;
constexpr int kPositionIterations = 3;
constexpr double kFloorThickness = 0.02;  // [m] what is lower than this is driven over
constexpr float kWallFriction = 0.3F;

b2Vec2 b2(double x, double y) {
  return {static_cast<float>(x), static_cast<float>(y)};
}
b2Vec2 b2(const Eigen::Vector2d& p) {
  return b2(p.x(), p.y());
}

// `id` is what touched() finds again: an entity's number, or a mover's.
void add_fixture(b2Body& body, const b2Shape& shape, double density, int id) {
  b2FixtureDef fixture;
  fixture.userData.pointer = static_cast<std::uintptr_t>(id);
  fixture.shape = &shape;
  fixture.density = static_cast<float>(density);
  fixture.friction = kWallFriction;
  fixture.restitution = 0.0F;
  body.CreateFixture(&fixture);
}

void add_obstacle(b2Body& ground, const Footprint& footprint) {
  if (footprint.outline.empty()) {
    b2CircleShape circle;
    circle.m_p = b2(footprint.center);
    circle.m_radius = static_cast<float>(footprint.radius);
    add_fixture(ground, circle, 0.0, footprint.entity);
    return;
  }
  const auto& outline = footprint.outline;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d& from = outline[i];
    const Eigen::Vector2d& to = outline[(i + 1) % outline.size()];
    if ((to - from).norm() < 0.01) continue;  // two vertices of Box2D must be 5 mm apart
    b2EdgeShape edge;
    edge.SetTwoSided(b2(from), b2(to));
    add_fixture(ground, edge, 0.0, footprint.entity);
  }
}

void add_robot_shape(b2Body& body, const Robot& robot) {
  const RobotFootprint& f = robot.footprint;
  if (f.radius > 0.0) {
    b2CircleShape circle;
    circle.m_radius = static_cast<float>(f.radius);
    add_fixture(body, circle, robot.mass / (kPi * f.radius * f.radius), 0);
    return;
  }
  b2PolygonShape box;
  box.SetAsBox(static_cast<float>(f.length / 2.0), static_cast<float>(f.width / 2.0));
  add_fixture(body, box, robot.mass / (f.length * f.width), 0);
}

// An obstacle that somebody else moves.
struct Mover {
  b2Body* body = nullptr;
  bool is_disc = false;
  double reach = 0.0;  // [m] from its origin
  Pose2 target;        // where it is after the next step
};

// Discs do not turn.
Pose2 place_of(bool is_disc, const Pose2& pose) {
  return is_disc ? Pose2{pose.x, pose.y, 0.0} : pose;
}

double reach_of(const Obstacle& obstacle) {
  return obstacle.is_disc() ? obstacle.radius : std::hypot(obstacle.length, obstacle.thickness);
}

}  // namespace

struct PlanarPhysics::State {
  State(const Robot& model, const Rng& rng) : world(b2Vec2(0.0F, 0.0F)), wheels(model, rng) {}

  b2World world;
  Wheels wheels;
  b2Body* robot = nullptr;
  std::vector<Mover> movers;  // index: id
  double robot_reach = 0.0;   // [m]

  void send_to_target(const Mover& mover, double dt);
};

// Beside the robot with the velocity that takes it there, so that the two push each other; far from
// it by a leap, asleep, which is all that there is to it and much cheaper.
void PlanarPhysics::State::send_to_target(const Mover& mover, double dt) {
  constexpr double kLeast = 1.0;  // [m] between mover and robot
  b2Body& body = *mover.body;
  const Pose2& target = mover.target;
  const b2Vec2 way = b2(target.x, target.y) - body.GetPosition();
  const double turn = angle_difference(body.GetAngle(), target.theta);
  if (way.LengthSquared() == 0.0F && std::abs(turn) < 1e-6) {
    if (body.GetLinearVelocity().LengthSquared() > 0.0F) body.SetLinearVelocity({0.0F, 0.0F});
    if (body.GetAngularVelocity() != 0.0F) body.SetAngularVelocity(0.0F);
    return;
  }
  const b2Vec2 from_robot = body.GetPosition() - robot->GetPosition();
  if (from_robot.Length() > mover.reach + robot_reach + kLeast) {
    body.SetTransform(b2(target.x, target.y), static_cast<float>(target.theta));
    body.SetAwake(false);
    return;
  }
  const auto rate = static_cast<float>(1.0 / dt);
  body.SetLinearVelocity(rate * way);
  body.SetAngularVelocity(rate * static_cast<float>(turn));
}

PlanarPhysics::PlanarPhysics(const World& world, const Robot& robot, const Pose2& start,
                             const Rng& rng)
    : state_(std::make_unique<State>(robot, rng)) {
  b2BodyDef ground_def;
  b2Body* ground = state_->world.CreateBody(&ground_def);
  for (const Footprint& footprint : footprints(world, kFloorThickness, robot.height)) {
    const EntityKind kind = world.entities[static_cast<std::size_t>(footprint.entity)].kind;
    if (kind == EntityKind::floor || kind == EntityKind::door) continue;
    add_obstacle(*ground, footprint);
  }

  b2BodyDef robot_def;
  robot_def.type = b2_dynamicBody;
  robot_def.position = b2(start.x, start.y);
  robot_def.angle = static_cast<float>(start.theta);
  robot_def.allowSleep = false;
  state_->robot = state_->world.CreateBody(&robot_def);
  add_robot_shape(*state_->robot, robot);
  state_->robot_reach = robot.footprint.reach();
}

PlanarPhysics::~PlanarPhysics() = default;
PlanarPhysics::PlanarPhysics(PlanarPhysics&&) noexcept = default;
PlanarPhysics& PlanarPhysics::operator=(PlanarPhysics&&) noexcept = default;

int PlanarPhysics::add(const Obstacle& obstacle) {
  const auto id = static_cast<int>(state_->movers.size());
  const Pose2 pose = place_of(obstacle.is_disc(), obstacle.pose);
  b2BodyDef def;
  def.type = b2_kinematicBody;
  def.position = b2(pose.x, pose.y);
  def.angle = static_cast<float>(pose.theta);
  b2Body* body = state_->world.CreateBody(&def);
  if (obstacle.is_disc()) {
    b2CircleShape circle;
    circle.m_radius = static_cast<float>(obstacle.radius);
    add_fixture(*body, circle, 0.0, id);
  } else {
    b2PolygonShape leaf;
    leaf.SetAsBox(static_cast<float>(obstacle.length / 2.0),
                  static_cast<float>(obstacle.thickness / 2.0), b2(obstacle.length / 2.0, 0.0),
                  0.0F);
    add_fixture(*body, leaf, 0.0, id);
  }
  state_->movers.push_back({body, obstacle.is_disc(), reach_of(obstacle), pose});
  return id;
}

void PlanarPhysics::move(int id, const Pose2& pose) {
  CHECK(id >= 0 && static_cast<std::size_t>(id) < state_->movers.size());
  Mover& mover = state_->movers[static_cast<std::size_t>(id)];
  mover.target = place_of(mover.is_disc, pose);
}

void PlanarPhysics::step(const DriveCommand& command, double dt) {
  State& s = *state_;
  for (const Mover& mover : s.movers) s.send_to_target(mover, dt);

  s.wheels.drive(command, dt);
  const Twist2 now = robot_velocity();
  const Twist2 next = s.wheels.push(now, robot(), dt);
  s.robot->SetLinearVelocity(s.robot->GetWorldVector(b2(next.forward, next.left)));
  s.robot->SetAngularVelocity(static_cast<float>(next.turn));
  s.world.Step(static_cast<float>(dt), kVelocityIterations, kPositionIterations);
}

Pose2 PlanarPhysics::robot() const {
  const b2Vec2 p = state_->robot->GetPosition();
  return {p.x, p.y, normalized_angle(state_->robot->GetAngle())};
}

Twist2 PlanarPhysics::robot_velocity() const {
  const b2Vec2 v = state_->robot->GetLocalVector(state_->robot->GetLinearVelocity());
  return {v.x, v.y, state_->robot->GetAngularVelocity()};
}

const Wheels& PlanarPhysics::wheels() const {
  return state_->wheels;
}

std::optional<Touch> PlanarPhysics::touched() const {
  for (b2ContactEdge* c = state_->robot->GetContactList(); c != nullptr; c = c->next) {
    if (!c->contact->IsTouching()) continue;
    b2Fixture* other = c->contact->GetFixtureA();
    if (other->GetBody() == state_->robot) other = c->contact->GetFixtureB();
    const int id = static_cast<int>(other->GetUserData().pointer);
    const bool is_mover = other->GetBody()->GetType() == b2_kinematicBody;
    return is_mover ? Touch{.mover = id} : Touch{.entity = id};
  }
  return std::nullopt;
}

}  // namespace mapbed
