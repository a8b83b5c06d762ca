#include "worlds/loop_corridor/loop_corridor.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/geometry/angle.h"
#include "core/input_error.h"
#include "core/random.h"
#include "worlds/build/building.h"
#include "worlds/build/furnish.h"
#include "worlds/build/furniture.h"
#include "worlds/build/furniture_placer.h"

namespace mapbed {
namespace {

using Outline = std::vector<Eigen::Vector2d>;

constexpr double kWall = 0.2;       // [m]
constexpr double kDoorWidth = 1.0;  // [m]

struct LoopPlan {
  double length, width, corridor;
  double small_length, small_width;  // small_length 0: none

  bool nested() const { return small_length > 0.0; }
  // The small loop reaches from -west to the inner side of the large loop's west corridor.
  double west() const { return nested() ? small_length - corridor : 0.0; }
};

LoopPlan plan_of(const LoopCorridorOptions& o, Rng& rng) {
  const auto varied = [&](double value) {
    return o.seed == 0 ? value : value * rng.uniform(0.9, 1.1);
  };
  const LoopPlan plan{varied(o.length), varied(o.width), std::max(1.5, varied(o.corridor_width)),
                      varied(o.small_length), varied(o.small_width)};
  const double least = 2 * plan.corridor + 1.0;
  if (plan.length < least || plan.width < least ||
      (plan.nested() && (plan.small_length < least || plan.small_width < least ||
                         plan.small_width > plan.width - 1.0))) {
    throw InputError(
        "world 'loop_corridor': the loops leave no block between their corridors, or the small one "
        "is no less wide than the large one; take larger loops or a narrower corridor");
  }
  return plan;
}

// Floors lie left of the outer outline and right of the blocks' ones.
Outline outer_outline(const LoopPlan& p) {
  if (!p.nested()) return {{0, 0}, {p.length, 0}, {p.length, p.width}, {0, p.width}};
  const double west = -p.west();
  return {{west, 0},    {p.length, 0},      {p.length, p.width},
          {0, p.width}, {0, p.small_width}, {west, p.small_width}};
}

Outline rectangle(double low_x, double low_y, double high_x, double high_y) {
  return {{low_x, low_y}, {high_x, low_y}, {high_x, high_y}, {low_x, high_y}};
}

std::vector<Outline> blocks(const LoopPlan& p) {
  const double c = p.corridor;
  std::vector<Outline> result = {rectangle(c, c, p.length - c, p.width - c)};
  if (p.nested()) result.push_back(rectangle(c - p.west(), c, 0.0, p.small_width - c));
  return result;
}

// Walls along an outline (their faces lie on it) with shut doors and piers here and there.
// `floor_left`: the corridor lies left of the outline as it runs, the wall right of it.
void add_outline(World& world, const std::string& name, const Outline& outline, bool floor_left,
                 double features, Rng& rng) {
  const int stone = material_index(world, "concrete");
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d& from = outline[i];
    const Eigen::Vector2d& to = outline[(i + 1) % outline.size()];
    const Eigen::Vector2d way = (to - from).normalized();
    const Eigen::Vector2d left(-way.y(), way.x());
    const Eigen::Vector2d into_wall = floor_left ? Eigen::Vector2d(-left) : left;
    Wall wall{name + " " + std::to_string(i + 1), from + into_wall * kWall / 2,
              to + into_wall * kWall / 2, kWall};
    Entity piers{.name = wall.name + " piers", .kind = EntityKind::structure};
    const double length = (to - from).norm();
    // About one door or pier every four metres.
    for (double at = rng.uniform(1.0, 4.0); features > 0.0 && at < length - 1.2;
         at += rng.uniform(2.0, 6.0) / features) {
      if (rng.uniform() < 0.65) {
        wall.openings.push_back({.at = at,
                                 .width = kDoorWidth,
                                 .kind = OpeningKind::door,
                                 .door = {.opens_left = !floor_left}});
      } else {
        const double pier = rng.uniform(0.3, 0.8);
        const double jut = rng.uniform(0.05, 0.2);
        const Eigen::Vector2d middle = from + way * at - into_wall * jut / 2;
        piers.parts.push_back(
            {.name = "pier",
             .geometry = Box{{pier, jut, world.ceiling}},
             .entity_from_part =
                 upright({middle.x(), middle.y(), std::atan2(way.y(), way.x())}, world.ceiling / 2),
             .material = stone});
      }
    }
    add_wall(world, wall);
    if (!piers.parts.empty()) world.entities.push_back(std::move(piers));
  }
}

std::vector<WayPoint> large_round(const LoopPlan& p) {
  const double c = p.corridor / 2;
  return {{{c, c}}, {{p.length - c, c}}, {{p.length - c, p.width - c}}, {{c, p.width - c}}};
}

std::vector<WayPoint> small_round(const LoopPlan& p) {
  const double c = p.corridor / 2;
  const double west = c - p.west();
  return {{{c, c}}, {{c, p.small_width - c}}, {{west, p.small_width - c}}, {{west, c}}};
}

NamedPath path(const std::string& name, const std::vector<std::vector<WayPoint>>& rounds) {
  NamedPath result{name, {}, 0.35};
  for (const auto& round : rounds) {
    result.points.insert(result.points.end(), round.begin(), round.end());
  }
  result.points.push_back(rounds.front().front());
  return result;
}

// The first way of a closed round, as far as its fraction says.
std::vector<WayPoint> beginning(const std::vector<WayPoint>& round, double fraction) {
  const auto side = [&](std::size_t i) -> Eigen::Vector2d {
    return round[(i + 1) % round.size()].position - round[i].position;
  };
  double left = 0.0;
  for (std::size_t i = 0; i < round.size(); ++i) left += fraction * side(i).norm();
  std::vector<WayPoint> way;
  for (std::size_t i = 0; left > 0.0 && i < round.size(); ++i) {
    const double length = std::min(left, side(i).norm());
    way.push_back({round[i].position + length * side(i).normalized()});
    left -= length;
  }
  return way;
}

void add_paths(World& world, const LoopPlan& plan, const LoopCorridorOptions& options) {
  const std::vector<WayPoint> large = large_round(plan);
  std::vector<std::vector<WayPoint>> all(static_cast<std::size_t>(options.rounds),
                                         plan.nested() ? small_round(plan) : large);
  if (plan.nested()) all.push_back(large);
  NamedPath rounds = path("rounds", all);
  for (const WayPoint& point : beginning(large, options.last_round)) rounds.points.push_back(point);
  world.paths = {path("once", {large}), rounds};
}

// A few things against the walls of the straight corridors.
void add_furniture(World& world, const LoopPlan& plan, double features, Rng& rng) {
  FurniturePlacer placer(world);
  std::vector<Eigen::AlignedBox2d> strips;
  std::vector<std::vector<WayPoint>> rounds = {large_round(plan)};
  if (plan.nested()) rounds.push_back(small_round(plan));
  for (const auto& round : rounds) {
    for (std::size_t i = 0; i < round.size(); ++i) {
      const Eigen::Vector2d a = round[i].position;
      const Eigen::Vector2d b = round[(i + 1) % round.size()].position;
      const Eigen::Vector2d half = Eigen::Vector2d::Constant(plan.corridor / 2);
      strips.emplace_back(a.cwiseMin(b) - half, a.cwiseMax(b) + half);
    }
  }
  for (const Eigen::AlignedBox2d& strip : strips) {
    const int pieces = static_cast<int>(std::lround(features * strip.sizes().maxCoeff() / 8.0));
    for (int i = 0; i < pieces; ++i) {
      const Pose2 pose = pose_at_wall(strip, 0.2, rng);
      switch (rng.index(3)) {
        case 0:
          placer.place(cabinet(world, pose, rng.uniform(0.6, 1.4), 0.36, 1.8));
          break;
        case 1:
          placer.place(bin(world, pose * Pose2{0.02, 0.0, 0.0}));
          break;
        default:
          placer.place(bench(world, pose * Pose2{0.06, 0.0, 0.0}, 1.5));
          break;
      }
    }
  }
}

}  // namespace

World build_loop_corridor(const LoopCorridorOptions& options) {
  Rng rng = Rng(options.seed).stream("loop_corridor");
  const LoopPlan plan = plan_of(options, rng);
  World world;
  world.name = "loop_corridor";
  const Eigen::Vector2d wall(kWall, kWall);
  add_floor(world, -wall, Eigen::Vector2d(plan.length, plan.width) + wall, "carpet");
  if (plan.nested()) {
    add_floor(world, {-plan.west() - kWall, -kWall}, {-kWall, plan.small_width + kWall}, "carpet");
  }
  add_outline(world, "outer wall", outer_outline(plan), true, options.features, rng);
  int number = 0;
  for (const Outline& block : blocks(plan)) {
    add_outline(world, "block " + std::to_string(++number) + " wall", block, false,
                options.features, rng);
  }
  add_paths(world, plan, options);
  world.crowd.walkers = options.walkers;
  CrowdRoute route{.name = "round", .closed = true};
  for (const WayPoint& point : large_round(plan)) route.points.push_back(point.position);
  world.crowd.routes = {route};
  if (options.features > 0.0) add_furniture(world, plan, options.features, rng);
  check_clearance(world);
  return world;
}

}  // namespace mapbed
