#include "worlds/build/free_ways.h"

#include <cmath>

#include <fmt/format.h>

#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr double kLow = 0.02;             // [m] what is lower can be driven over
constexpr double kHigh = 1.8;             // [m] what is higher does not matter to anybody
constexpr double kWalkerClearance = 0.3;  // [m]

Eigen::AlignedBox2d box_of(const Footprint& footprint) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& corner : footprint.outline) box.extend(corner);
  if (footprint.outline.empty()) {
    const Eigen::Vector2d r = Eigen::Vector2d::Constant(footprint.radius);
    box.extend(Eigen::Vector2d(footprint.center - r));
    box.extend(Eigen::Vector2d(footprint.center + r));
  }
  return box;
}

Eigen::AlignedBox2d box_of(const FreeWay& way) {
  return Eigen::AlignedBox2d(way.from.cwiseMin(way.to), way.from.cwiseMax(way.to));
}

std::vector<FreeWay> ways_of(const CrowdRoute& route) {
  std::vector<FreeWay> ways;
  const std::size_t n = route.points.size();
  for (std::size_t i = 0; i + 1 < n; ++i) {
    ways.push_back({route.points[i], route.points[i + 1], kWalkerClearance});
  }
  if (route.closed && n > 2) {
    ways.push_back({route.points[n - 1], route.points[0], kWalkerClearance});
  }
  return ways;
}

std::vector<FreeWay> ways_of(const NamedPath& path) {
  std::vector<FreeWay> ways;
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
    ways.push_back({path.points[i].position, path.points[i + 1].position, path.clearance});
  }
  return ways;
}

// Throws where the way comes too close to one of the obstacles.
void check_way(const World& world, const std::vector<Footprint>& obstacles, const FreeWay& way,
               const std::string& what) {
  for (const Footprint& obstacle : obstacles) {
    const Entity& entity = world.entities[static_cast<std::size_t>(obstacle.entity)];
    if (entity.kind == EntityKind::door) continue;
    if (box_of(obstacle).exteriorDistance(box_of(way)) >= way.clearance) continue;
    const double distance = distance_to(obstacle, way.from, way.to);
    if (distance >= way.clearance) continue;
    const std::string how =
        distance == 0.0 ? "runs through" : fmt::format("comes within {:.2f} m of", distance);
    throw InputError(fmt::format(
        "{} of world '{}' {} '{}' between ({:.2f} m, {:.2f} m) and ({:.2f} m, {:.2f} m); it needs "
        "{:.2f} m to either side: move the path or the obstacle",
        what, world.name, how, entity.name, way.from.x(), way.from.y(), way.to.x(), way.to.y(),
        way.clearance));
  }
}

std::vector<Footprint> obstacles_of(const World& world) {
  return footprints(world, kLow, kHigh);
}

void check(const World& world, const std::vector<Footprint>& obstacles, const NamedPath& path) {
  const std::string what = "path '" + path.name + "'";
  if (path.points.size() < 2) {
    throw InputError(what + " of world '" + world.name + "' has less than two points");
  }
  for (const FreeWay& way : ways_of(path)) check_way(world, obstacles, way, what);
}

void check(const World& world, const std::vector<Footprint>& obstacles, const CrowdRoute& route) {
  for (const FreeWay& way : ways_of(route)) {
    check_way(world, obstacles, way, "crowd route '" + route.name + "'");
  }
}

}  // namespace

std::vector<FreeWay> free_ways(const World& world) {
  std::vector<FreeWay> ways;
  const auto add = [&](const std::vector<FreeWay>& more) {
    ways.insert(ways.end(), more.begin(), more.end());
  };
  for (const NamedPath& path : world.paths) add(ways_of(path));
  for (const CrowdRoute& route : world.crowd.routes) add(ways_of(route));
  for (const StandingPlace& place : world.crowd.places) {
    ways.push_back({place.position, place.position, place.radius});
  }
  for (const Door& door : world.doors) {
    // The quarter disc that the leaf sweeps lies within a disc about the middle of its chord.
    const Pose2 half_open = door.world_from_hinge * Pose2{0.0, 0.0, door.open_angle / 2};
    const double half_chord = door.width * std::sin(std::abs(door.open_angle) / 2);
    const Eigen::Vector2d middle =
        half_open * Eigen::Vector2d(door.width * std::cos(door.open_angle / 2), 0.0);
    ways.push_back({middle, middle, half_chord});
  }
  return ways;
}

Furnisher::Furnisher(World& world) : world_(world), ways_(free_ways(world)) {
  for (std::size_t id = 0; id < world.entities.size(); ++id) {
    take(world.entities[id], static_cast<int>(id));
  }
}

void Furnisher::keep_free(const FreeWay& way) {
  ways_.push_back(way);
}

bool Furnisher::place(Entity entity, double gap) {
  for (const Footprint& footprint : footprints(entity, 0, kLow, world_.ceiling)) {
    if (!is_free(footprint, gap)) return false;
  }
  take(entity, static_cast<int>(world_.entities.size()));
  world_.entities.push_back(std::move(entity));
  return true;
}

bool Furnisher::is_free(const Footprint& footprint, double gap) const {
  const Eigen::AlignedBox2d box = box_of(footprint);
  for (const FreeWay& way : ways_) {
    if (box.exteriorDistance(box_of(way)) >= way.clearance + gap) continue;
    if (distance_to(footprint, way.from, way.to) < way.clearance + gap) return false;
  }
  for (const Taken& taken : taken_) {
    if (box.exteriorDistance(taken.box) >= gap) continue;
    if (distance_between(footprint, taken.footprint) < gap) return false;
  }
  return true;
}

void Furnisher::take(const Entity& entity, int id) {
  for (const Footprint& footprint : footprints(entity, id, kLow, kHigh)) {
    taken_.push_back({footprint, box_of(footprint)});
  }
}

void check_path(const World& world, const NamedPath& path) {
  check(world, obstacles_of(world), path);
}

void check_route(const World& world, const CrowdRoute& route) {
  check(world, obstacles_of(world), route);
}

void check_ways(const World& world) {
  const std::vector<Footprint> obstacles = obstacles_of(world);
  for (const NamedPath& path : world.paths) check(world, obstacles, path);
  for (const CrowdRoute& route : world.crowd.routes) check(world, obstacles, route);
}

}  // namespace mapbed
