#include "sim/actors/crowd.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

using Eigen::Vector2d;

constexpr double kLongestStep = 0.005;  // [s] of the forces
constexpr double kWishEvery = 0.05;     // [s] people think this often
constexpr double kBlockAhead = 0.9;     // [m] a blocker stands before the robot's outline
constexpr double kWalks = 0.1;          // [m/s] who is slower stands

std::vector<Wall> leaves_of(const SimState& state) {
  std::vector<Wall> leaves;
  for (const Obstacle& o : state.obstacles) {
    if (o.is_disc()) continue;
    leaves.push_back({o.pose.position(), o.pose * Vector2d(o.length, 0.0), 0.0});
  }
  return leaves;
}

}  // namespace

struct Crowd::State {
  Vector2d wish_of_blocker(std::size_t i, const Obstacle& robot);
  void wish_to_stand(std::size_t i);
  void wish_to_keep_up(std::size_t i);
  void think(const Obstacle& robot);

  NavigationMap map;
  CrowdOptions options;
  std::vector<Person> people;
  std::vector<Walker> bodies;
  int first_entity = 0;
  int clothes = 0;         // material of everybody
  double time = 0.0;       // [s]
  double next_wish = 0.0;  // [s]
};

Crowd::Crowd(const World& world, const NavigationMap& map, const Obstacle& robot,
             const CrowdOptions& options, int first_entity, const Rng& rng) {
  CrowdMembers members = drawn_crowd(world, map, robot, options, rng);
  const int clothes = members.people.empty() ? 0 : material_index(world, "clothes");
  state_ = std::make_unique<State>(State{.map = map,
                                         .options = options,
                                         .people = std::move(members.people),
                                         .bodies = std::move(members.bodies),
                                         .first_entity = first_entity,
                                         .clothes = clothes});
}

Crowd::~Crowd() = default;
Crowd::Crowd(Crowd&&) noexcept = default;
Crowd& Crowd::operator=(Crowd&&) noexcept = default;

// Goes and stands before the robot for a while, then walks on.
Vector2d Crowd::State::wish_of_blocker(std::size_t i, const Obstacle& robot) {
  Person& person = people[i];
  Walker& body = bodies[i];
  if (time > person.blocks_until) {
    person.blocks_from = time + options.block_pause;
    person.blocks_until = person.blocks_from + options.block_time;
  }
  body.keeps_heading = false;
  const double reach = robot.radius + kBlockAhead;
  const Vector2d ahead = robot.pose.position() +
                         reach * Vector2d(std::cos(robot.pose.theta), std::sin(robot.pose.theta));
  const bool can_get_there =
      (ahead - body.position).norm() < 8.0 && map.is_straight_way(body.position, ahead, 0.2);
  if (time < person.blocks_from || !can_get_there) {
    return person.itinerary->wish(body.position, person.speed, 0.8 * body.radius, map, time);
  }
  const Vector2d to_go = ahead - body.position;
  const Vector2d to_robot = robot.pose.position() - body.position;
  body.wished_heading = std::atan2(to_robot.y(), to_robot.x());
  body.keeps_heading = to_go.norm() < 0.4;
  const double speed = std::min(person.speed, 1.5 * to_go.norm());
  return to_go.norm() > 1e-6 ? Vector2d(speed / to_go.norm() * to_go) : Vector2d::Zero();
}

void Crowd::State::wish_to_stand(std::size_t i) {
  const Vector2d back = people[i].place - bodies[i].position;
  bodies[i].wish = back.norm() > 0.15 ? Vector2d(back) : Vector2d::Zero();
  bodies[i].keeps_heading = back.norm() < 0.5;
  bodies[i].wished_heading = people[i].heading;
}

// Beside the leader, on whichever side it is.
void Crowd::State::wish_to_keep_up(std::size_t i) {
  Walker& body = bodies[i];
  const Walker& leader = bodies[static_cast<std::size_t>(people[i].leader)];
  const Vector2d left(-std::sin(leader.heading), std::cos(leader.heading));
  const double side = left.dot(body.position - leader.position) >= 0.0 ? 1.0 : -1.0;
  const Vector2d to_go = leader.position + side * kPairGap * left - body.position;
  Vector2d wish = leader.velocity + to_go;
  if (wish.norm() > 1.8) wish *= 1.8 / wish.norm();
  body.keeps_heading = leader.wish.norm() < 0.1 && to_go.norm() < 0.3;
  body.wished_heading = leader.heading;
  body.wish = body.keeps_heading ? Vector2d::Zero() : wish;
}

void Crowd::State::think(const Obstacle& robot) {
  for (std::size_t i = 0; i < people.size(); ++i) {
    Person& person = people[i];
    Walker& body = bodies[i];
    if (person.kind == PersonKind::blocker) {
      body.wish = wish_of_blocker(i, robot);
    } else if (person.kind == PersonKind::standing) {
      wish_to_stand(i);
    } else if (person.leader >= 0) {
      wish_to_keep_up(i);
    } else {
      body.wish = person.itinerary->wish(body.position, person.speed, 0.8 * body.radius, map, time);
      body.keeps_heading = person.itinerary->is_pausing(time);
      if (!body.keeps_heading) body.wished_heading = body.heading;
    }
  }
}

void Crowd::step(double dt, const SimState& state) {
  State& s = *state_;
  const int steps = std::max(1, static_cast<int>(std::ceil(dt / kLongestStep - 1e-9)));
  const double h = dt / steps;
  const Obstacle& robot = state.robot;
  const RoundObstacle obstacle{robot.pose.position(), robot.velocity,
                               robot.radius + s.options.robot_margin};
  const std::vector<Wall> leaves = leaves_of(state);
  for (int i = 0; i < steps; ++i) {
    if (s.time >= s.next_wish - 1e-9) {
      s.think(robot);
      s.next_wish = s.time + kWishEvery;
    }
    advance(s.bodies, s.map, leaves, {&obstacle, 1}, s.options.force, h);
    s.time += h;
  }
  for (std::size_t i = 0; i < s.people.size(); ++i) {
    const Walker& body = s.bodies[i];
    const double forward =
        body.velocity.dot(Vector2d(std::cos(body.heading), std::sin(body.heading)));
    s.people[i].gait.advance(forward, dt);
  }
}

std::size_t Crowd::size() const {
  return state_->people.size();
}

PersonView Crowd::person(std::size_t index) const {
  const Walker& body = state_->bodies[index];
  const Person& person = state_->people[index];
  const Pose2 pose{body.position.x(), body.position.y(), body.heading};
  return {.kind = person.kind,
          .body = {.pose = pose, .velocity = body.velocity, .radius = body.radius},
          .posture = {pose, person.gait.legs()},
          .motion = body.velocity.norm() > kWalks ? Motion::moving : Motion::waiting};
}

std::vector<Entity> Crowd::entities() const {
  std::vector<Entity> entities;
  for (std::size_t i = 0; i < size(); ++i) {
    const std::string name = "person " + std::to_string(i + 1);
    entities.push_back(person_entity(name, person(i).posture, state_->clothes));
  }
  return entities;
}

void Crowd::append_obstacles(std::vector<Obstacle>& obstacles) const {
  for (std::size_t i = 0; i < size(); ++i) obstacles.push_back(person(i).body);
}

void Crowd::append_poses(std::vector<MovingPose>& poses) const {
  for (std::size_t i = 0; i < size(); ++i) {
    const PersonView view = person(i);
    int part = 0;
    for (const Pose3& pose : part_poses(view.posture)) {
      poses.push_back({state_->first_entity + static_cast<int>(i), part++, pose, view.motion});
    }
  }
}

}  // namespace mapbed
