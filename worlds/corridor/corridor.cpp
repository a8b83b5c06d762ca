#include "worlds/corridor/corridor.h"

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

constexpr double kWall = 0.15;       // [m]
constexpr double kDoorWidth = 0.95;  // [m]
constexpr double kEndGap = 1.5;      // [m] from a path's end to the end of the corridor

struct CorridorPlan {
  double length;
  double width;
  double depth;
  std::vector<double> south_doors;
  std::vector<double> north_doors;
};

CorridorPlan plan_of(const CorridorOptions& o, Rng& rng) {
  const auto varied = [&](double value) {
    return o.seed == 0 ? value : value * rng.uniform(0.9, 1.1);
  };
  CorridorPlan plan{varied(o.length), std::max(1.8, varied(o.width)), varied(o.room_depth), {}, {}};
  const double step = o.doors_a_side > 0 ? plan.length / o.doors_a_side : plan.length;
  if (step < 2.2) {
    throw InputError("world 'corridor': " + std::to_string(o.doors_a_side) +
                     " doors do not fit along " + std::to_string(std::lround(plan.length)) +
                     " m; take fewer doors or a longer corridor");
  }
  for (auto* doors : {&plan.south_doors, &plan.north_doors}) {
    for (int i = 0; i < o.doors_a_side; ++i) {
      doors->push_back(step * (i + 0.5) + rng.uniform(-0.5, 0.5) * (step - 2.2));
    }
  }
  return plan;
}

// A long wall of the corridor with its doors, which open into the rooms.
void add_side(World& world, const CorridorPlan& plan, bool north, const CorridorOptions& o,
              Rng& rng) {
  const double y = north ? plan.width + kWall / 2 : -kWall / 2;
  Wall wall{north ? "north wall" : "south wall", {-kWall / 2, y}, {plan.length + kWall / 2, y}};
  for (const double at : north ? plan.north_doors : plan.south_doors) {
    const double fraction_open = o.door_mean_open + o.door_mean_shut > 0.0
                                     ? o.door_mean_open / (o.door_mean_open + o.door_mean_shut)
                                     : 0.0;
    wall.openings.push_back({.at = at + kWall / 2,
                             .width = kDoorWidth,
                             .kind = OpeningKind::door,
                             .door = {.starts_open = rng.uniform() < fraction_open,
                                      .hinge_at_end = rng.uniform() < 0.5,
                                      .opens_left = north,
                                      .mean_open = o.door_mean_open,
                                      .mean_shut = o.door_mean_shut,
                                      .opens_within = 1.2}});
  }
  add_wall(world, wall);
}

// The rooms behind one side: a back wall and partitions half way between the doors.
std::vector<Eigen::AlignedBox2d> add_rooms(World& world, const CorridorPlan& plan, bool north) {
  const auto& doors = north ? plan.north_doors : plan.south_doors;
  const double near = north ? plan.width + kWall / 2 : -kWall / 2;
  const double far = north ? near + plan.depth : near - plan.depth;
  const std::string side = north ? "north" : "south";
  std::vector<double> cuts = {-kWall / 2};
  for (std::size_t i = 0; i + 1 < doors.size(); ++i) cuts.push_back((doors[i] + doors[i + 1]) / 2);
  cuts.push_back(plan.length + kWall / 2);
  add_wall(world, {side + " back wall", {cuts.front(), far}, {cuts.back(), far}, kWall, "brick"});
  std::vector<Eigen::AlignedBox2d> rooms;
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    add_wall(world, {side + " partition", {cuts[i], near}, {cuts[i], far}, 0.12});
    if (i + 1 == cuts.size()) break;
    rooms.emplace_back(Eigen::Vector2d(cuts[i], std::min(near, far)),
                       Eigen::Vector2d(cuts[i + 1], std::max(near, far)));
  }
  return rooms;
}

void add_crowd(World& world, const CorridorPlan& plan, const CorridorOptions& o) {
  CrowdRules& crowd = world.crowd;
  crowd.walkers = o.walkers;
  crowd.standing = o.standing;
  crowd.blockers = o.blockers;
  const double middle = plan.width / 2;
  const double lane = std::min(0.8, plan.width / 2 - 0.5);  // walkers keep to the right
  for (const double side : {-lane, lane}) {
    crowd.routes.push_back({.name = side < 0 ? "south lane" : "north lane",
                            .points = {{1.0, middle + side}, {plan.length - 1.0, middle + side}},
                            .weight = 3.0});
  }
  const auto add_visits = [&](const std::vector<double>& doors, double inside) {
    for (const double door : doors) {
      const double far_end = door < plan.length / 2 ? plan.length - 1.0 : 1.0;
      crowd.routes.push_back({.name = "visit",
                              .points = {{far_end, middle}, {door, middle}, {door, inside}},
                              .weight = 0.5});
    }
  };
  add_visits(plan.south_doors, -kWall - plan.depth / 2);
  add_visits(plan.north_doors, plan.width + kWall + plan.depth / 2);
  for (double x = 3.0; x < plan.length - 2.0; x += 5.0) {
    crowd.places.push_back({{x, middle + (plan.width / 2 - 0.6)}, -kPi / 2, 0.3});
  }
}

// Things along the corridor's walls.
void add_clutter(FurniturePlacer& placer, const World& world, const CorridorPlan& plan,
                 double clutter, Rng& rng) {
  const Eigen::AlignedBox2d corridor(Eigen::Vector2d(0.4, 0.0),
                                     Eigen::Vector2d(plan.length - 0.4, plan.width));
  bool bin_stands = false;
  for (int i = 0; i < 40 && !bin_stands; ++i) {
    bin_stands = placer.place(bin(world, pose_at_wall(corridor, 0.24, rng)));
  }
  const int pieces = static_cast<int>(std::lround(clutter * plan.length / 5.0));
  for (int i = 0; i < pieces; ++i) {
    const Pose2 pose = pose_at_wall(corridor, 0.2, rng);
    switch (rng.index(3)) {
      case 0:
        placer.place(cabinet(world, pose, rng.uniform(0.6, 1.2), 0.36, 1.2));
        break;
      case 1:
        placer.place(chair(world, pose * Pose2{0.1, 0.0, 0.0}));
        break;
      default:
        placer.place(bench(world, pose * Pose2{0.06, 0.0, 0.0}, 1.4));
        break;
    }
  }
}

}  // namespace

World build_corridor(const CorridorOptions& options) {
  Rng rng = Rng(options.seed).stream("corridor");
  const CorridorPlan plan = plan_of(options, rng);
  World world;
  world.name = "corridor";
  const double reach = plan.depth + kWall;
  add_floor(world, {-kWall, -reach}, {plan.length + kWall, plan.width + reach}, "carpet");
  std::vector<Eigen::AlignedBox2d> rooms;
  for (const bool north : {false, true}) {
    add_side(world, plan, north, options, rng);
    const auto more = add_rooms(world, plan, north);
    rooms.insert(rooms.end(), more.begin(), more.end());
  }
  const double low = -kWall / 2;
  add_wall(world, {"west end", {low, low}, {low, plan.width - low}, kWall});
  add_wall(world,
           {"east end", {plan.length - low, low}, {plan.length - low, plan.width - low}, kWall});

  const WayPoint west{{kEndGap, plan.width / 2}};
  const WayPoint east{{plan.length - kEndGap, plan.width / 2}};
  world.paths = {{"one_way", {west, east}, 0.35}, {"there_and_back", {west, east, west}, 0.35}};
  add_crowd(world, plan, options);

  FurniturePlacer placer(world);
  add_clutter(placer, world, plan, options.clutter, rng);
  for (const Eigen::AlignedBox2d& room : rooms) {
    furnish_office_room(placer, world, room, false, 0.7 * options.clutter, rng);
  }
  check_clearance(world);
  return world;
}

}  // namespace mapbed
