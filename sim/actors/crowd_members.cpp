#include "sim/actors/crowd_members.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/angle.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

using Eigen::Vector2d;

constexpr int kAttempts = 300;  // to find a free place for somebody

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

// Puts one after the other where there is room.
class Drawing {
 public:
  Drawing(const World& world, const NavigationMap& map, const Obstacle& robot,
          const CrowdOptions& options)
      : world_(world), map_(map), robot_(robot), options_(options) {}

  bool add_walker(Rng& rng, PersonKind kind);
  void add_companion(Rng rng);  // beside the last walker, if there is room
  bool add_standing(Rng rng);

  CrowdMembers members;

 private:
  void draw_body(Walker& body, Person& person, Rng& rng) const;
  bool place_on_route(Walker& body, Person& person, Rng& rng) const;
  bool is_free(const Walker& body) const;
  void take(const Walker& body, Person person);

  const World& world_;
  const NavigationMap& map_;
  const Obstacle& robot_;
  const CrowdOptions& options_;
};

bool Drawing::is_free(const Walker& body) const {
  const Vector2d& place = body.position;
  if (map_.clearance(place) < body.radius + 0.05) return false;
  if ((place - robot_.pose.position()).norm() < body.radius + robot_.radius + 0.3) return false;
  return std::none_of(members.bodies.begin(), members.bodies.end(), [&](const Walker& other) {
    return (place - other.position).norm() < body.radius + other.radius + 0.05;
  });
}

void Drawing::take(const Walker& body, Person person) {
  members.bodies.push_back(body);
  members.people.push_back(std::move(person));
}

void Drawing::draw_body(Walker& body, Person& person, Rng& rng) const {
  body.radius = rng.uniform(0.25, 0.35);
  body.mass = rng.uniform(60.0, 90.0);
  person.speed = std::clamp(rng.normal(options_.mean_speed, options_.speed_sigma), 0.4, 1.8);
  const GaitOptions gait{.step_length = rng.uniform(0.6, 0.8)};
  person.gait = Gait(gait, rng.uniform());
}

bool Drawing::place_on_route(Walker& body, Person& person, Rng& rng) const {
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const CrowdRoute& route = drawn_route(world_.crowd, rng);
    const std::size_t count = route.points.size();
    const std::size_t from = rng.index(route.closed ? count : count - 1);
    const Vector2d a = route.points[from];
    const Vector2d b = route.points[(from + 1) % count];
    const Vector2d scatter = 0.3 * Vector2d(rng.normal(), rng.normal());
    body.position = a + rng.uniform() * (b - a) + scatter;
    const bool ahead = rng.uniform() < 0.5;
    if (!is_free(body)) continue;
    const std::size_t next = ahead ? (from + 1) % count : from;
    const Vector2d way = route.points[next] - body.position;
    body.heading = std::atan2(way.y(), way.x());
    person.itinerary.emplace(route, world_.crowd, next, ahead ? 1 : -1, rng.stream("itinerary"));
    return true;
  }
  return false;
}

bool Drawing::add_walker(Rng& rng, PersonKind kind) {
  Walker body;
  Person person;
  person.kind = kind;
  draw_body(body, person, rng);
  if (!place_on_route(body, person, rng)) return false;
  person.blocks_from = rng.uniform(0.2, 1.0) * options_.block_pause;
  person.blocks_until = person.blocks_from + options_.block_time;
  take(body, std::move(person));
  return true;
}

void Drawing::add_companion(Rng rng) {
  Walker body;
  Person person;
  draw_body(body, person, rng);
  const std::size_t leader = members.bodies.size() - 1;
  const Walker& other = members.bodies[leader];
  const double side = other.heading + kPi / 2.0;
  for (const double sign : {1.0, -1.0}) {
    body.position = other.position + sign * kPairGap * Vector2d(std::cos(side), std::sin(side));
    if (!is_free(body)) continue;
    body.heading = other.heading;
    person.leader = static_cast<int>(leader);
    take(body, std::move(person));
    return;
  }
}

bool Drawing::add_standing(Rng rng) {
  Walker body;
  Person person;
  person.kind = PersonKind::standing;
  draw_body(body, person, rng);
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const StandingPlace& place = world_.crowd.places[rng.index(world_.crowd.places.size())];
    const double angle = rng.uniform(-kPi, kPi);
    const double r = place.radius * std::sqrt(rng.uniform());
    body.position = place.position + r * Vector2d(std::cos(angle), std::sin(angle));
    if (!is_free(body)) continue;
    person.place = body.position;
    person.heading = normalized_angle(place.heading + 0.4 * rng.normal());
    body.heading = person.heading;
    take(body, std::move(person));
    return true;
  }
  return false;
}

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

CrowdMembers drawn_crowd(const World& world, const NavigationMap& map, const Obstacle& robot,
                         const CrowdOptions& options, const Rng& rng) {
  const int walkers = options.walkers >= 0 ? options.walkers : world.crowd.walkers;
  const int standing = options.standing >= 0 ? options.standing : world.crowd.standing;
  const int blockers = options.blockers >= 0 ? options.blockers : world.crowd.blockers;
  const int total = walkers + standing + blockers;
  check_rules(world, walkers + blockers, standing);

  Drawing drawing(world, map, robot, options);
  const auto count = [&] { return static_cast<int>(drawing.members.people.size()); };
  const auto next_stream = [&] { return rng.stream("person", drawing.members.people.size()); };
  while (count() < walkers + blockers) {
    const bool is_walker = count() < walkers;
    Rng own = next_stream();
    if (!drawing.add_walker(own, is_walker ? PersonKind::walker : PersonKind::blocker)) {
      does_not_fit(world, drawing.members.people.size(), total, "the routes");
    }
    const bool has_company = is_walker && own.uniform() < world.crowd.group_fraction / 2.0;
    if (has_company && count() < walkers) drawing.add_companion(next_stream());
  }
  for (int k = 0; k < standing; ++k) {
    if (drawing.add_standing(next_stream())) continue;
    does_not_fit(world, drawing.members.people.size(), total, "the places");
  }
  return std::move(drawing.members);
}

}  // namespace mapbed
