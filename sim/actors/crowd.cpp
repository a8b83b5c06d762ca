#include "sim/actors/crowd.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/geometry/angle.h"
#include "core/input_error.h"
#include "sim/actors/itinerary.h"

namespace mapbed {
namespace {

using Eigen::Vector2d;

constexpr double kLongestStep = 0.005;  // [s] of the forces
constexpr double kWishEvery = 0.05;     // [s] people think this often
constexpr int kAttempts = 300;          // to find a free place for somebody
constexpr double kPairGap = 0.75;       // [m] between two who walk together
constexpr double kBlockAhead = 0.9;     // [m] a blocker stands before the robot's outline

struct Person {
  PersonKind kind = PersonKind::walker;
  double speed = 1.0;                  // [m/s] wished
  std::optional<Itinerary> itinerary;  // of walkers who lead, and of blockers
  int leader = -1;                     // of the one who walks beside
  Vector2d place = Vector2d::Zero();   // of who stands
  double heading = 0.0;                // [rad] of who stands
  double blocks_from = 0.0;            // [s] next or present time
  double blocks_until = 0.0;           // [s]
  Gait gait{{}, 0.0};
};

const CrowdRoute& drawn_route(const CrowdRules& rules, Rng& rng) {
  double total = 0.0;
  for (const CrowdRoute& route : rules.routes) total += route.weight;
  double below = rng.uniform() * total;
  for (const CrowdRoute& route : rules.routes) {
    if (below < route.weight) return route;
    below -= route.weight;
  }
  return rules.routes.back();
}

bool is_free(const Vector2d& place, double radius, const FloorPlan& plan,
             const std::vector<Walker>& others, const RobotView& robot) {
  if (plan.clearance(place) < radius + 0.05) return false;
  if ((place - robot.pose.position()).norm() < radius + robot.radius + 0.3) return false;
  for (const Walker& other : others) {
    if ((place - other.position).norm() < radius + other.radius + 0.05) return false;
  }
  return true;
}

}  // namespace

struct Crowd::State {
  State(const FloorPlan& p, const CrowdOptions& o) : plan(p), options(o) {}

  bool add_walker(const World& world, const RobotView& robot, Rng& rng, PersonKind kind);
  void add_companion(const RobotView& robot, Rng rng);
  bool add_standing(const World& world, const RobotView& robot, Rng rng);
  void draw_body(Walker& body, Person& person, Rng& rng) const;
  bool place_on_route(const CrowdRules& rules, const RobotView& robot, Walker& body, Person& person,
                      Rng& rng);
  Vector2d wish_of_blocker(std::size_t i, const RobotView& robot);
  void wish_to_stand(std::size_t i);
  void wish_to_keep_up(std::size_t i);
  void think(const RobotView& robot);

  FloorPlan plan;
  CrowdOptions options;
  std::vector<Walker> bodies;
  std::vector<Person> people;
  double time = 0.0;       // [s]
  double next_wish = 0.0;  // [s]
};

void Crowd::State::draw_body(Walker& body, Person& person, Rng& rng) const {
  body.radius = rng.uniform(0.25, 0.35);
  body.mass = rng.uniform(60.0, 90.0);
  person.speed = std::clamp(rng.normal(options.mean_speed, options.speed_sigma), 0.4, 1.8);
  const GaitOptions gait{.step_length = rng.uniform(0.6, 0.8)};
  person.gait = Gait(gait, rng.uniform());
}

bool Crowd::State::place_on_route(const CrowdRules& rules, const RobotView& robot, Walker& body,
                                  Person& person, Rng& rng) {
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const CrowdRoute& route = drawn_route(rules, rng);
    const std::size_t count = route.points.size();
    const std::size_t from = rng.index(route.closed ? count : count - 1);
    const Vector2d a = route.points[from];
    const Vector2d b = route.points[(from + 1) % count];
    const Vector2d scatter = 0.3 * Vector2d(rng.normal(), rng.normal());
    body.position = a + rng.uniform() * (b - a) + scatter;
    const bool ahead = rng.uniform() < 0.5;
    if (!is_free(body.position, body.radius, plan, bodies, robot)) continue;
    const std::size_t next = ahead ? (from + 1) % count : from;
    const Vector2d way = route.points[next] - body.position;
    body.heading = std::atan2(way.y(), way.x());
    person.itinerary.emplace(route, rules, next, ahead ? 1 : -1, rng.stream("itinerary"));
    return true;
  }
  return false;
}

bool Crowd::State::add_walker(const World& world, const RobotView& robot, Rng& rng,
                              PersonKind kind) {
  Walker body;
  Person person;
  person.kind = kind;
  draw_body(body, person, rng);
  if (!place_on_route(world.crowd, robot, body, person, rng)) return false;
  person.blocks_from = rng.uniform(0.2, 1.0) * options.block_pause;
  person.blocks_until = person.blocks_from + options.block_time;
  bodies.push_back(body);
  people.push_back(std::move(person));
  return true;
}

// Beside the last walker.
void Crowd::State::add_companion(const RobotView& robot, Rng rng) {
  Walker body;
  Person person;
  draw_body(body, person, rng);
  const std::size_t leader = bodies.size() - 1;
  const double side = bodies[leader].heading + kPi / 2.0;
  for (const double sign : {1.0, -1.0}) {
    body.position =
        bodies[leader].position + sign * kPairGap * Vector2d(std::cos(side), std::sin(side));
    if (!is_free(body.position, body.radius, plan, bodies, robot)) continue;
    body.heading = bodies[leader].heading;
    person.leader = static_cast<int>(leader);
    bodies.push_back(body);
    people.push_back(std::move(person));
    return;
  }
}

bool Crowd::State::add_standing(const World& world, const RobotView& robot, Rng rng) {
  Walker body;
  Person person;
  person.kind = PersonKind::standing;
  draw_body(body, person, rng);
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const StandingPlace& place = world.crowd.places[rng.index(world.crowd.places.size())];
    const double angle = rng.uniform(-kPi, kPi);
    const double r = place.radius * std::sqrt(rng.uniform());
    body.position = place.position + r * Vector2d(std::cos(angle), std::sin(angle));
    if (!is_free(body.position, body.radius, plan, bodies, robot)) continue;
    person.place = body.position;
    person.heading = normalized_angle(place.heading + 0.4 * rng.normal());
    body.heading = person.heading;
    bodies.push_back(body);
    people.push_back(std::move(person));
    return true;
  }
  return false;
}

namespace {

[[noreturn]] void does_not_fit(const World& world, std::size_t placed, int wanted,
                               const std::string& what) {
  throw InputError("the crowd does not fit: only " + std::to_string(placed) + " of " +
                   std::to_string(wanted) + " people found a free place on " + what +
                   " of world '" + world.name + "'; ask for fewer");
}

void check_rules(const World& world, int walkers, int standing) {
  if (walkers > 0 && world.crowd.routes.empty()) {
    throw InputError("world '" + world.name +
                     "' has no routes for people to walk; add routes to its crowd, or ask for no "
                     "walkers");
  }
  if (standing > 0 && world.crowd.places.empty()) {
    throw InputError("world '" + world.name +
                     "' has no places for people to stand; add places to its crowd, or ask for "
                     "nobody to stand");
  }
}

}  // namespace

CrowdOptions with_people(CrowdOptions options, const CrowdRules& rules, int people) {
  const int total = rules.walkers + rules.standing + rules.blockers;
  const auto rounded = [&](int part) {
    return total > 0 ? static_cast<int>(std::lround(static_cast<double>(people) * part / total))
                     : 0;
  };
  options.blockers = rounded(rules.blockers);
  options.standing = rounded(rules.blockers + rules.standing) - options.blockers;
  options.walkers = people - options.blockers - options.standing;
  return options;
}

Crowd::Crowd(const World& world, const FloorPlan& plan, const RobotView& robot,
             const CrowdOptions& options, const Rng& rng)
    : state_(std::make_unique<State>(plan, options)) {
  State& s = *state_;
  const int walkers = options.walkers >= 0 ? options.walkers : world.crowd.walkers;
  const int standing = options.standing >= 0 ? options.standing : world.crowd.standing;
  const int blockers = options.blockers >= 0 ? options.blockers : world.crowd.blockers;
  const int total = walkers + standing + blockers;
  check_rules(world, walkers + blockers, standing);

  const auto next_stream = [&] { return rng.stream("person", s.people.size()); };
  while (static_cast<int>(s.people.size()) < walkers + blockers) {
    const bool is_walker = static_cast<int>(s.people.size()) < walkers;
    Rng own = next_stream();
    if (!s.add_walker(world, robot, own, is_walker ? PersonKind::walker : PersonKind::blocker)) {
      does_not_fit(world, s.people.size(), total, "the routes");
    }
    const bool has_company = is_walker && own.uniform() < world.crowd.group_share / 2.0;
    if (has_company && static_cast<int>(s.people.size()) < walkers) {
      s.add_companion(robot, next_stream());
    }
  }
  for (int k = 0; k < standing; ++k) {
    if (s.add_standing(world, robot, next_stream())) continue;
    does_not_fit(world, s.people.size(), total, "the places");
  }
}

Crowd::~Crowd() = default;
Crowd::Crowd(Crowd&&) noexcept = default;
Crowd& Crowd::operator=(Crowd&&) noexcept = default;

// Goes and stands before the robot for a while, then walks on.
Vector2d Crowd::State::wish_of_blocker(std::size_t i, const RobotView& robot) {
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
      (ahead - body.position).norm() < 8.0 && plan.is_straight_way(body.position, ahead, 0.2);
  if (time < person.blocks_from || !can_get_there) {
    return person.itinerary->wish(body.position, person.speed, 0.8 * body.radius, plan, time);
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

void Crowd::State::think(const RobotView& robot) {
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
      body.wish =
          person.itinerary->wish(body.position, person.speed, 0.8 * body.radius, plan, time);
      body.keeps_heading = person.itinerary->is_pausing(time);
      if (!body.keeps_heading) body.wished_heading = body.heading;
    }
  }
}

void Crowd::step(const RobotView& robot, std::span<const Wall> doors, double dt) {
  State& s = *state_;
  const int steps = std::max(1, static_cast<int>(std::ceil(dt / kLongestStep - 1e-9)));
  const double h = dt / steps;
  const RoundObstacle obstacle{robot.pose.position(), robot.velocity,
                               robot.radius + s.options.robot_margin};
  for (int i = 0; i < steps; ++i) {
    if (s.time >= s.next_wish - 1e-9) {
      s.think(robot);
      s.next_wish = s.time + kWishEvery;
    }
    advance(s.bodies, s.plan, doors, {&obstacle, 1}, s.options.force, h);
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
  return {person.kind,
          {body.position.x(), body.position.y(), body.heading},
          body.velocity,
          body.radius,
          body.velocity.norm() > 0.1,
          person.gait.legs()};
}

}  // namespace mapbed
