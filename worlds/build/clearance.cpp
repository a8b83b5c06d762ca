#include "worlds/build/clearance.h"

#include <cmath>

#include <fmt/format.h>

#include "core/input_error.h"
#include "worlds/geometry/footprint.h"

namespace mapbed {
namespace {

constexpr double kLow = 0.02;             // [m] what is lower can be driven over
constexpr double kHigh = 1.8;             // [m] what is higher does not matter to anybody
constexpr double kWalkerClearance = 0.3;  // [m]

std::vector<ClearStrip> strips_of(const CrowdRoute& route) {
  std::vector<ClearStrip> strips;
  const std::size_t n = route.points.size();
  for (std::size_t i = 0; i + 1 < n; ++i) {
    strips.push_back({route.points[i], route.points[i + 1], kWalkerClearance});
  }
  if (route.closed && n > 2) {
    strips.push_back({route.points[n - 1], route.points[0], kWalkerClearance});
  }
  return strips;
}

std::vector<ClearStrip> strips_of(const NamedPath& path) {
  std::vector<ClearStrip> strips;
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
    strips.push_back({path.points[i].position, path.points[i + 1].position, path.clearance});
  }
  return strips;
}

// Throws where the strip comes too close to one of the obstacles.
void check_strip(const World& world, const std::vector<Footprint>& obstacles,
                 const ClearStrip& strip, const std::string& what) {
  for (const Footprint& obstacle : obstacles) {
    const Entity& entity = world.entities[static_cast<std::size_t>(obstacle.entity)];
    if (entity.kind == EntityKind::door) continue;
    if (bounds_of(obstacle).exteriorDistance(bounds_of(strip)) >= strip.clearance) continue;
    const double distance = distance_to(obstacle, strip.from, strip.to);
    if (distance >= strip.clearance) continue;
    const std::string how =
        distance == 0.0 ? "runs through" : fmt::format("comes within {:.2f} m of", distance);
    throw InputError(fmt::format(
        "{} of world '{}' {} '{}' between ({:.2f} m, {:.2f} m) and ({:.2f} m, {:.2f} m); it needs "
        "{:.2f} m to either side: move the path or the obstacle",
        what, world.name, how, entity.name, strip.from.x(), strip.from.y(), strip.to.x(),
        strip.to.y(), strip.clearance));
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
  for (const ClearStrip& strip : strips_of(path)) check_strip(world, obstacles, strip, what);
}

void check(const World& world, const std::vector<Footprint>& obstacles, const CrowdRoute& route) {
  for (const ClearStrip& strip : strips_of(route)) {
    check_strip(world, obstacles, strip, "crowd route '" + route.name + "'");
  }
}

}  // namespace

std::vector<ClearStrip> clear_strips(const World& world) {
  std::vector<ClearStrip> strips;
  const auto add = [&](const std::vector<ClearStrip>& more) {
    strips.insert(strips.end(), more.begin(), more.end());
  };
  for (const NamedPath& path : world.paths) add(strips_of(path));
  for (const CrowdRoute& route : world.crowd.routes) add(strips_of(route));
  for (const StandingPlace& place : world.crowd.places) {
    strips.push_back({place.position, place.position, place.radius});
  }
  for (const Door& door : world.doors) {
    // The quarter disc that the leaf sweeps lies within a disc about the middle of its chord.
    const Pose2 half_open = door.world_from_hinge * Pose2{0.0, 0.0, door.open_angle / 2};
    const double half_chord = door.width * std::sin(std::abs(door.open_angle) / 2);
    const Eigen::Vector2d middle =
        half_open * Eigen::Vector2d(door.width * std::cos(door.open_angle / 2), 0.0);
    strips.push_back({middle, middle, half_chord});
  }
  return strips;
}

Eigen::AlignedBox2d bounds_of(const ClearStrip& strip) {
  return Eigen::AlignedBox2d(strip.from.cwiseMin(strip.to), strip.from.cwiseMax(strip.to));
}

void check_clearance(const World& world, const NamedPath& path) {
  check(world, obstacles_of(world), path);
}

void check_clearance(const World& world, const CrowdRoute& route) {
  check(world, obstacles_of(world), route);
}

void check_clearance(const World& world) {
  const std::vector<Footprint> obstacles = obstacles_of(world);
  for (const NamedPath& path : world.paths) check(world, obstacles, path);
  for (const CrowdRoute& route : world.crowd.routes) check(world, obstacles, route);
}

}  // namespace mapbed
