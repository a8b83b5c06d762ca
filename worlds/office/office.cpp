#include "worlds/office/office.h"

#include <algorithm>
#include <string>
#include <vector>

#include "core/geometry/angle.h"
#include "core/input_error.h"
#include "core/random.h"
#include "worlds/build/building.h"
#include "worlds/build/furnish.h"
#include "worlds/build/furniture.h"
#include "worlds/build/furniture_placer.h"
#include "worlds/office/corridor_tags.h"

namespace mapbed {
namespace {

constexpr double kDoorWidth = 1.0;   // [m]
constexpr double kDoorMargin = 0.9;  // [m] of a door's middle from the corner of its room
constexpr double kPathClearance = 0.35;

enum Side { south, east, north, west };

// A room with the door through which the corridor enters it.
struct OfficeRoom {
  std::string name;
  Eigen::Vector2d low, high;   // middle lines of its walls
  Side corridor_side = south;  // the side of the ring along which its door lies
  bool inner = false;          // lies inside the ring
  bool behind_glass = false;
  bool open = true;
  double first = 0.0, last = 0.0;  // where the door wall begins and ends, along the corridor
  double door = 0.0;               // where the door's middle is, along the corridor
};

// The main lines of the building; all four sides are alike.
struct OfficePlan {
  double size;
  double outer;   // middle line of the corridor's outer wall: from `outer` to size - outer
  double inner;   // of its inner wall
  double middle;  // of the corridor

  double wall_line(Side side, bool is_inner) const {
    const double in = is_inner ? inner : outer;
    return side == south || side == west ? in : size - in;
  }
  double middle_line(Side side) const {
    return side == south || side == west ? middle : size - middle;
  }
};

bool runs_along_x(Side side) {
  return side == south || side == north;
}

// A point given along a side of the ring and across it.
Eigen::Vector2d at(Side side, double along, double across) {
  return runs_along_x(side) ? Eigen::Vector2d(along, across) : Eigen::Vector2d(across, along);
}

// `count` pieces of a line; the cuts jitter by up to a sixth of a piece.
std::vector<double> cuts(double from, double to, int count, Rng& rng) {
  std::vector<double> result = {from};
  const double step = (to - from) / count;
  for (int i = 1; i < count; ++i) result.push_back(from + step * (i + rng.uniform(-1, 1) / 6));
  result.push_back(to);
  return result;
}

OfficePlan plan_of(const OfficeOptions& o, Rng& rng) {
  const auto varied = [&](double value) {
    return o.seed == 0 ? value : value * rng.uniform(0.9, 1.1);
  };
  const double size = varied(o.size);
  const double depth = varied(o.room_depth);
  const double width = std::max(1.5, varied(o.corridor_width));
  const OfficePlan plan{size, depth, depth + width, depth + width / 2};
  const double block = size - 2 * plan.inner;
  const double widest =
      o.rooms_a_side - 2 > 0 ? (size - 2 * depth - 3.6) / (o.rooms_a_side - 2) : 9;
  if (block < 6.0 || block / o.inner_rooms < 2.4 || widest < 2.4) {
    throw InputError("world 'office': " + std::to_string(o.rooms_a_side) + " rooms a side and " +
                     std::to_string(o.inner_rooms) +
                     " inner rooms do not fit; a larger size, fewer or less deep rooms do");
  }
  return plan;
}

// Rooms between the outside and the ring, side by side.
void add_outer_rooms(std::vector<OfficeRoom>& rooms, const OfficePlan& plan, Side side,
                     const OfficeOptions& o, Rng& rng) {
  const double s = plan.size;
  const double d = plan.outer;
  const bool has_corners = runs_along_x(side);
  const int count = has_corners ? o.rooms_a_side : o.rooms_a_side - 1;
  std::vector<double> at_cuts;
  if (has_corners) {  // the corner rooms reach past the corner by the 1.8 m that their doors need
    at_cuts = cuts(d + 1.8, s - d - 1.8, count - 2, rng);
    at_cuts.insert(at_cuts.begin(), 0.0);
    at_cuts.push_back(s);
  } else {
    at_cuts = cuts(d, s - d, count, rng);
  }
  const bool glass = o.glass_wall && side == east && count >= 3;
  if (glass) at_cuts.erase(at_cuts.begin() + 2);  // two rooms make the meeting room
  for (std::size_t i = 0; i + 1 < at_cuts.size(); ++i) {
    OfficeRoom room;
    room.name = "room " + std::to_string(rooms.size() + 1);
    room.corridor_side = side;
    room.behind_glass = glass && i == 1;
    const double across_low = side == south || side == west ? 0.0 : s - d;
    room.low = at(side, at_cuts[i], across_low);
    room.high = at(side, at_cuts[i + 1], across_low + d);
    room.first = std::max(at_cuts[i], d);
    room.last = std::min(at_cuts[i + 1], s - d);
    rooms.push_back(room);
  }
}

// Two columns of rooms in the middle, with doors to the west and to the east.
void add_inner_rooms(std::vector<OfficeRoom>& rooms, const OfficePlan& plan, Side side,
                     const OfficeOptions& o, Rng& rng) {
  const double half = plan.size / 2;
  const double low = side == west ? plan.inner : half;
  const double high = side == west ? half : plan.size - plan.inner;
  const std::vector<double> at_cuts = cuts(plan.inner, plan.size - plan.inner, o.inner_rooms, rng);
  for (std::size_t i = 0; i + 1 < at_cuts.size(); ++i) {
    OfficeRoom room;
    room.name = "room " + std::to_string(rooms.size() + 1);
    room.corridor_side = side;
    room.inner = true;
    room.low = {low, at_cuts[i]};
    room.high = {high, at_cuts[i + 1]};
    room.first = at_cuts[i];
    room.last = at_cuts[i + 1];
    rooms.push_back(room);
  }
}

std::vector<OfficeRoom> rooms_of(const OfficePlan& plan, const OfficeOptions& o, Rng& rng) {
  std::vector<OfficeRoom> rooms;
  for (const Side side : {south, east, north, west}) add_outer_rooms(rooms, plan, side, o, rng);
  for (const Side side : {east, west}) add_inner_rooms(rooms, plan, side, o, rng);
  for (OfficeRoom& room : rooms) {
    room.open = room.behind_glass || rng.uniform() < o.open_rooms;
    room.door = room.behind_glass ? room.first + kDoorMargin
                                  : rng.uniform(room.first + kDoorMargin, room.last - kDoorMargin);
  }
  return rooms;
}

// The wall between a side of the ring and the rooms on it, with their doors.
void add_corridor_wall(World& world, const OfficePlan& plan, const std::vector<OfficeRoom>& rooms,
                       Side side, bool inner) {
  const double line = plan.wall_line(side, inner);
  // Outside, the walls of south and north run on between the corner rooms and their neighbours.
  const double from = inner ? plan.inner : (runs_along_x(side) ? 0.0 : plan.outer);
  static const char* const kNames[] = {"south", "east", "north", "west"};
  Wall wall{std::string(inner ? "inner " : "outer ") + kNames[side] + " wall", at(side, from, line),
            at(side, plan.size - from, line)};
  for (const OfficeRoom& room : rooms) {
    if (room.corridor_side != side || room.inner != inner) continue;
    // Doors open into their rooms, which lie left of the wall's run where north or west is left.
    const bool room_is_higher = (side == north || side == east) != inner;
    const bool opens_left = runs_along_x(side) ? room_is_higher : !room_is_higher;
    wall.openings.push_back({.at = room.door - from,
                             .width = kDoorWidth,
                             .kind = OpeningKind::door,
                             .door = {.starts_open = room.open, .opens_left = opens_left}});
    if (room.behind_glass) {
      const double glass_from = room.door + kDoorWidth / 2 + 0.3;
      const double glass_to = room.last - 0.3;
      wall.openings.push_back({.at = (glass_from + glass_to) / 2 - from,
                               .width = glass_to - glass_from,
                               .kind = OpeningKind::glass});
    }
  }
  add_wall(world, wall);
}

// The walls between neighbouring rooms: the low end of each room that does not begin at a corner.
void add_partitions(World& world, const OfficePlan& plan, const std::vector<OfficeRoom>& rooms) {
  for (const OfficeRoom& room : rooms) {
    const bool along_x = runs_along_x(room.corridor_side);
    const double begin = along_x ? room.low.x() : room.low.y();
    const double corner = room.inner ? plan.inner : (along_x ? 0.0 : plan.outer);
    if (begin - corner < 0.1) continue;
    const Eigen::Vector2d end =
        along_x ? Eigen::Vector2d(begin, room.high.y()) : Eigen::Vector2d(room.high.x(), begin);
    add_wall(world, {room.name + " partition", room.low, end, 0.12});
  }
  const double half = plan.size / 2;
  add_wall(world, {"middle partition", {half, plan.inner}, {half, plan.size - plan.inner}, 0.12});
}

// Once round the ring, counter-clockwise from the south-west corner, with a visit to the rooms.
std::vector<WayPoint> round(const OfficePlan& plan, std::vector<OfficeRoom> rooms) {
  std::vector<WayPoint> points;
  for (const Side side : {south, east, north, west}) {
    const bool upwards = side == south || side == east;
    const double line = plan.middle_line(side);
    points.push_back({at(side, upwards ? plan.middle : plan.size - plan.middle, line)});
    std::sort(rooms.begin(), rooms.end(), [&](const OfficeRoom& a, const OfficeRoom& b) {
      return upwards ? a.door < b.door : a.door > b.door;
    });
    for (const OfficeRoom& room : rooms) {
      if (room.corridor_side != side || !room.open) continue;
      const Eigen::Vector2d middle = (room.low + room.high) / 2;
      const double inside = runs_along_x(side) ? middle.y() : middle.x();
      points.push_back({at(side, room.door, line)});
      points.push_back({at(side, room.door, inside)});
      points.push_back({at(side, room.door, line)});
    }
  }
  return points;
}

void add_paths(World& world, const OfficePlan& plan, const std::vector<OfficeRoom>& rooms) {
  const std::vector<WayPoint> ring = round(plan, {});
  const std::vector<WayPoint> visits = round(plan, rooms);
  const auto path = [&](const std::string& name, int rings, int tours) {
    NamedPath result{name, {}, kPathClearance};
    for (int i = 0; i < rings; ++i) {
      result.points.insert(result.points.end(), ring.begin(), ring.end());
    }
    for (int i = 0; i < tours; ++i) {
      result.points.insert(result.points.end(), visits.begin(), visits.end());
    }
    result.points.push_back(ring.front());
    return result;
  };
  world.paths = {path("ring", 1, 0), path("tour", 1, 1), path("long_tour", 3, 2),
                 path("tag_tour", 4, 3)};
}

void add_crowd(World& world, const OfficePlan& plan, const std::vector<OfficeRoom>& rooms,
               const OfficeOptions& o) {
  CrowdRoute ring{.name = "ring", .closed = true, .weight = 2.0};
  for (const WayPoint& point : round(plan, {})) ring.points.push_back(point.position);
  world.crowd.walkers = o.walkers;
  world.crowd.standing = o.standing;
  world.crowd.routes = {ring};
  for (const OfficeRoom& room : rooms) {
    if (!room.open) continue;
    const double line = plan.middle_line(room.corridor_side);
    const Eigen::Vector2d middle = (room.low + room.high) / 2;
    const double inside = runs_along_x(room.corridor_side) ? middle.y() : middle.x();
    const Eigen::Vector2d goal = at(room.corridor_side, room.door, inside);
    CrowdRoute route{.name = room.name, .points = {at(room.corridor_side, plan.middle, line)}};
    route.points.push_back(at(room.corridor_side, room.door, line));
    route.points.push_back(goal);
    world.crowd.routes.push_back(route);
    world.crowd.places.push_back({goal, 0.0, 0.6});
  }
}

// Where the ring's walls are free of doors and glass, along the corridor.
std::vector<TagStrip> free_strips(const OfficePlan& plan, const std::vector<OfficeRoom>& rooms) {
  constexpr double kCorner = 0.3, kBesideDoor = 0.3;  // [m]
  std::vector<TagStrip> strips;
  for (const Side side : {south, east, north, west}) {
    for (const bool inner : {false, true}) {
      const double begin = inner ? plan.inner : plan.outer;
      // Away from the wall: outer walls look inwards, inner ones outwards.
      const double into_ring = (side == south || side == west) == inner ? -1.0 : 1.0;
      const double surface = plan.wall_line(side, inner) + into_ring * Wall{}.thickness / 2;
      const double facing = runs_along_x(side) ? into_ring * kPi / 2 : into_ring > 0.0 ? 0.0 : kPi;
      std::vector<std::pair<double, double>> taken;
      for (const OfficeRoom& room : rooms) {
        if (room.corridor_side != side || room.inner != inner) continue;
        taken.emplace_back(
            room.door - kDoorWidth / 2 - kBesideDoor,
            room.behind_glass ? room.last : room.door + kDoorWidth / 2 + kBesideDoor);
      }
      std::sort(taken.begin(), taken.end());
      taken.emplace_back(plan.size - begin - kCorner, 0.0);
      double from = begin + kCorner;
      for (const auto& [low, high] : taken) {
        if (low > from) strips.push_back({at(side, from, surface), at(side, low, surface), facing});
        from = std::max(from, high);
      }
    }
  }
  return strips;
}

}  // namespace

World build_office(const OfficeOptions& options) {
  Rng rng = Rng(options.seed).stream("office");
  const OfficePlan plan = plan_of(options, rng);
  const std::vector<OfficeRoom> rooms = rooms_of(plan, options, rng);

  World world;
  world.name = "office";
  const Eigen::Vector2d far_corner(plan.size, plan.size);
  add_floor(world, {0.0, 0.0}, far_corner, "carpet");
  add_walls_around(world, "outside", {0.0, 0.0}, far_corner, 0.3, "brick");
  for (const Side side : {south, east, north, west}) {
    for (const bool inner : {false, true}) add_corridor_wall(world, plan, rooms, side, inner);
  }
  add_partitions(world, plan, rooms);
  add_paths(world, plan, rooms);
  add_crowd(world, plan, rooms, options);

  FurniturePlacer placer(world);
  for (const OfficeRoom& room : rooms) {
    if (room.behind_glass) {  // nobody puts cabinets before the glass
      const double line = plan.wall_line(room.corridor_side, room.inner);
      placer.keep_clear(
          {at(room.corridor_side, room.door, line), at(room.corridor_side, room.last, line), 0.9});
    }
    furnish_office_room(placer, world, {room.low, room.high}, room.behind_glass, options.furniture,
                        rng);
  }
  check_clearance(world);
  add_tags(world, free_strips(plan, rooms), options.tags, material_index(world, Wall{}.material),
           Rng(options.seed).stream("office tags"));
  return world;
}

}  // namespace mapbed
