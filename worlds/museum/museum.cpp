#include "worlds/museum/museum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/geometry/angle.h"
#include "core/random.h"
#include "worlds/build/building.h"
#include "worlds/build/furniture.h"
#include "worlds/build/furniture_placer.h"

namespace mapbed {
namespace {

constexpr double kWall = 0.4;        // [m]
constexpr double kPierDepth = 0.8;   // [m] of the piers, and so of the niches between them
constexpr double kClearance = 0.45;  // [m] of the paths

// Lanes at which people and robots walk, as fractions of the hall; exhibits stand between them.
constexpr std::array<double, 5> kLanesX = {0.1, 0.3, 0.5, 0.7, 0.9};
constexpr std::array<double, 6> kLanesY = {0.08, 0.24, 0.42, 0.6, 0.77, 0.93};

struct Hall {
  double width;
  double length;

  Eigen::Vector2d crossing(std::size_t column, std::size_t row) const {
    return {width * kLanesX[column], length * kLanesY[row]};
  }
};

void add_shell(World& world, const Hall& hall, Rng& rng) {
  const double out = kWall / 2;
  const Eigen::Vector2d sw(-out, -out), se(hall.width + out, -out);
  const Eigen::Vector2d ne(hall.width + out, hall.length + out), nw(-out, hall.length + out);
  add_floor(world, sw - Eigen::Vector2d(out, out), ne + Eigen::Vector2d(out, out), "parquet");
  add_wall(world, {"south wall",
                   sw,
                   se,
                   kWall,
                   "stone",
                   {{.at = hall.width / 2, .width = 5.0, .kind = OpeningKind::glass}}});
  add_wall(world, {"east wall", se, ne, kWall, "stone"});
  add_wall(world, {"north wall", ne, nw, kWall, "stone"});
  add_wall(world, {"west wall", nw, sw, kWall, "stone"});
  Entity piers{.name = "piers", .kind = EntityKind::structure};
  for (const double x : {kPierDepth / 2, hall.width - kPierDepth / 2}) {
    for (double y = rng.uniform(1.0, 2.5); y < hall.length - 0.5; y += rng.uniform(2.2, 4.5)) {
      piers.parts.push_back({.name = "pier",
                             .geometry = Box{{kPierDepth, rng.uniform(0.3, 0.9), world.ceiling}},
                             .entity_from_part = upright({x, y, 0.0}, world.ceiling / 2),
                             .material = material_index(world, "stone")});
    }
  }
  world.entities.push_back(std::move(piers));
}

NamedPath path(const Hall& hall, const std::string& name,
               const std::vector<std::array<std::size_t, 2>>& crossings) {
  NamedPath result{name, {}, kClearance};
  for (const auto& [column, row] : crossings) {
    result.points.push_back({hall.crossing(column, row)});
  }
  return result;
}

void add_paths(World& world, const Hall& hall) {
  world.paths = {path(hall, "tour_with_one_loop", {{1, 1}, {3, 1}, {3, 3}, {1, 3}, {1, 1}}),
                 path(hall, "long_tour",
                      {{1, 1},
                       {1, 0},
                       {3, 0},
                       {3, 1},
                       {1, 1},
                       {1, 2},
                       {3, 2},
                       {3, 3},
                       {1, 3},
                       {1, 4},
                       {3, 4},
                       {3, 5},
                       {1, 5},
                       {1, 3},
                       {2, 3},
                       {2, 1},
                       {1, 1}})};
  // On along its first lane: the robot comes to where it was, and the drive to 57 m.
  NamedPath& tour = world.paths.front();
  tour.points.push_back({hall.crossing(1, 1) + Eigen::Vector2d(1.25, 0.0)});
}

// Visitors walk round a rectangle of lanes each.
void add_routes(World& world, const Hall& hall, Rng& rng) {
  for (int i = 0; i < 10; ++i) {
    std::size_t column = rng.index(kLanesX.size() - 1);
    std::size_t row = rng.index(kLanesY.size() - 1);
    const std::size_t columns = 1 + rng.index(kLanesX.size() - 1 - column);
    const std::size_t rows = 1 + rng.index(kLanesY.size() - 1 - row);
    CrowdRoute route{.name = "round " + std::to_string(i + 1), .closed = true};
    route.points = {hall.crossing(column, row), hall.crossing(column + columns, row),
                    hall.crossing(column + columns, row + rows), hall.crossing(column, row + rows)};
    if (rng.uniform() < 0.5) std::reverse(route.points.begin(), route.points.end());
    world.crowd.routes.push_back(std::move(route));
  }
}

// Puts exhibits into one field between the lanes.
class Curator {
 public:
  Curator(World& world, Rng& rng) : world_(world), placer_(world), rng_(rng) {}

  void fill(const Eigen::AlignedBox2d& field) {
    const Eigen::Vector2d c = field.center();
    const double turn = rng_.index(2) == 0 ? 0.0 : kPi / 2;
    const Pose2 middle{c.x() + rng_.uniform(-0.2, 0.2), c.y() + rng_.uniform(-0.2, 0.2), turn};
    switch (rng_.index(7)) {
      case 0:
        showcases(middle);
        break;
      case 1:
        statue(middle);
        break;
      case 2:
        thick_columns(field);
        break;
      case 3:
        thin_columns(field);
        break;
      case 4:
        free_wall(middle, 0.5 * field.sizes().minCoeff());
        break;
      default:
        placer_.place(bench(world_, middle * Pose2{-0.6, 0.0, 0.0}));
        placer_.place(showcase(world_, middle * Pose2{1.0, 0.0, 0.0}, 1.6, 0.9));
        break;
    }
  }

 private:
  void showcases(const Pose2& middle) {
    const double apart = rng_.uniform(0.5, 0.8);
    for (const double x : {-apart, apart}) {
      placer_.place(showcase(world_, middle * Pose2{x, 0.0, 0.0}, rng_.uniform(1.2, 2.2), 0.8));
    }
  }
  void statue(const Pose2& middle) {
    placer_.place(pedestal(world_, middle, rng_.uniform(0.6, 1.0)));
    for (int i = 0; i < 6; ++i) {
      const double angle = kPi / 3 * i;
      placer_.place(
          rope_post(world_, middle * Pose2{1.1 * std::cos(angle), 1.1 * std::sin(angle), 0.0}));
    }
  }
  void thick_columns(const Eigen::AlignedBox2d& field) {
    const double radius = rng_.uniform(0.25, 0.4);
    const double apart = rng_.uniform(0.2, 0.28) * field.sizes().x();
    for (const double x : {-apart, apart}) {
      const Eigen::Vector2d at = field.center() + Eigen::Vector2d(x, 0.0);
      placer_.place(column(world_, {at.x(), at.y(), 0.0}, radius, "stone"));
    }
  }
  // In pairs 0.25 to 0.45 m apart: to a laser, people who stand still.
  void thin_columns(const Eigen::AlignedBox2d& field) {
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector2d at =
          field.center() + 0.3 * field.sizes().cwiseProduct(Eigen::Vector2d(
                                     rng_.uniform(-1.0, 1.0), rng_.uniform(-1.0, 1.0)));
      const Pose2 pair{at.x(), at.y(), rng_.uniform(0.0, kPi)};
      const double apart = rng_.uniform(0.25, 0.45);
      const double radius = rng_.uniform(0.06, 0.1);
      for (const double x : {-apart / 2, apart / 2}) {
        placer_.place(column(world_, pair * Pose2{x, 0.0, 0.0}, radius, "metal"));
      }
    }
  }
  void free_wall(const Pose2& middle, double length) {
    Entity wall{.name = "free wall",
                .kind = EntityKind::structure,
                .world_from_entity = upright(middle),
                .parts = {{.name = "wall",
                           .geometry = Box{{length, 0.25, 2.4}},
                           .entity_from_part = upright({}, 1.2),
                           .material = material_index(world_, "plaster")}}};
    placer_.place(std::move(wall));
  }

  World& world_;
  FurniturePlacer placer_;
  Rng& rng_;
};

// Before each showcase, where there is room to stand and no path of the robot.
void add_standing_places(World& world) {
  const std::vector<Footprint> obstacles = footprints(world, 0.02, 1.8);
  const auto is_open = [&](const Eigen::Vector2d& at) {
    for (const Footprint& obstacle : obstacles) {
      if (distance_to(obstacle, at) < 0.45) return false;
    }
    for (const NamedPath& path : world.paths) {
      for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
        Footprint way;
        way.outline = {path.points[i].position, path.points[i + 1].position};
        if (distance_to(way, at) < 0.9) return false;
      }
    }
    return true;
  };
  for (const Entity& entity : world.entities) {
    if (entity.name != "showcase") continue;
    for (const double angle : {0.0, kPi / 2, kPi, -kPi / 2}) {
      const Pose2 place =
          planar(entity.world_from_entity) * Pose2{0.0, 0.0, angle} * Pose2{1.2, 0.0, kPi};
      if (is_open(place.position())) {
        world.crowd.places.push_back({place.position(), place.theta, 0.4});
      }
    }
  }
}

}  // namespace

World build_museum(const MuseumOptions& options) {
  Rng rng = Rng(options.seed).stream("museum");
  const auto varied = [&](double value) {
    return options.seed == 0 ? value : value * rng.uniform(0.9, 1.1);
  };
  const Hall hall{varied(options.width), varied(options.length)};
  World world;
  world.name = "museum";
  world.ceiling = 5.0;
  add_shell(world, hall, rng);
  add_paths(world, hall);
  add_routes(world, hall, rng);
  world.crowd.walkers = options.walkers;
  world.crowd.standing = options.standing;
  world.crowd.blockers = options.blockers;
  world.crowd.pause_fraction = 0.5;
  world.crowd.mean_pause = 8.0;

  Curator curator(world, rng);
  for (std::size_t column = 0; column + 1 < kLanesX.size(); ++column) {
    for (std::size_t row = 0; row + 1 < kLanesY.size(); ++row) {
      const Eigen::Vector2d low = hall.crossing(column, row);
      const Eigen::Vector2d high = hall.crossing(column + 1, row + 1);
      const double middle = (low.y() + high.y()) / 2;
      if (rng.uniform() < options.exhibits) curator.fill({low, Eigen::Vector2d(high.x(), middle)});
      if (rng.uniform() < options.exhibits) curator.fill({Eigen::Vector2d(low.x(), middle), high});
    }
  }
  add_standing_places(world);
  check_clearance(world);
  return world;
}

}  // namespace mapbed
