#include "worlds/build/building.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "core/geometry/angle.h"
#include "core/geometry/pose2.h"

namespace mapbed {
namespace {

constexpr double kDoorHeight = 2.05;      // [m]
constexpr double kLeafThickness = 0.04;   // [m]
constexpr double kFramePost = 0.06;       // [m] along the wall
constexpr double kFrameJut = 0.02;        // [m] out of the wall, on either side
constexpr double kPaneThickness = 0.012;  // [m]
constexpr double kPaneWidth = 1.25;       // [m] at most, between posts
constexpr double kThinnest = 0.001;       // [m] of a piece of wall
constexpr double kOpenAngle = 1.6;        // [rad]

// A wall under construction: its entity's frame has x along the wall and its origin at the start.
struct Site {
  World& world;
  const Wall& wall;
  Pose2 world_from_wall;
  double length;
  int material;

  Entity entity(const std::string& name, EntityKind kind) const {
    return {.name = name, .kind = kind, .world_from_entity = upright(world_from_wall)};
  }

  // A block that fills the wall from one place to another.
  static Part block(const std::string& name, double from, double to, double thickness,
                    double bottom, double top, int material) {
    return {.name = name,
            .geometry = Box{{to - from, thickness, top - bottom}},
            .entity_from_part = upright({(from + to) / 2, 0.0, 0.0}, (bottom + top) / 2),
            .material = material};
  }
};

void add_frame(const Site& site, const std::string& name, double from, double to) {
  Entity frame = site.entity(name + " frame", EntityKind::structure);
  const int wood = material_index(site.world, "wood");
  const double thickness = site.wall.thickness + 2 * kFrameJut;
  frame.parts = {Site::block("post", from - kFramePost, from, thickness, 0.0, kDoorHeight, wood),
                 Site::block("post", to, to + kFramePost, thickness, 0.0, kDoorHeight, wood),
                 Site::block("head", from - kFramePost, to + kFramePost, thickness, kDoorHeight,
                             kDoorHeight + kFramePost, wood)};
  site.world.entities.push_back(std::move(frame));
}

void add_door(const Site& site, const std::string& name, double from, double to,
              const DoorStyle& style) {
  add_frame(site, name, from, to);
  const double hinge = style.hinge_at_end ? to : from;
  const Pose2 wall_from_hinge{hinge, 0.0, style.hinge_at_end ? kPi : 0.0};
  Door door{.name = name,
            .entity = static_cast<int>(site.world.entities.size()),
            .world_from_hinge = site.world_from_wall * wall_from_hinge,
            .width = to - from,
            .open_angle = style.hinge_at_end == style.opens_left ? -kOpenAngle : kOpenAngle,
            .starts_open = style.starts_open,
            .mean_open = style.mean_open,
            .mean_shut = style.mean_shut,
            .opens_within = style.opens_within};
  const Pose2 turned{0.0, 0.0, style.starts_open ? door.open_angle : 0.0};
  Entity leaf{.name = name,
              .kind = EntityKind::door,
              .world_from_entity = upright(door.world_from_hinge * turned)};
  // 5 mm of air all round.
  leaf.parts = {Site::block("leaf", 0.005, door.width - 0.005, kLeafThickness, 0.005,
                            kDoorHeight - 0.005, material_index(site.world, "wood"))};
  site.world.doors.push_back(std::move(door));
  site.world.entities.push_back(std::move(leaf));
}

void add_panes(const Site& site, const std::string& name, double from, double to) {
  const int glass = material_index(site.world, "glass");
  const int metal = material_index(site.world, "metal");
  const int panes = std::max(1, static_cast<int>(std::ceil((to - from) / kPaneWidth)));
  const double step = (to - from) / panes;
  constexpr double kPost = 0.05;
  Entity pane = site.entity(name, EntityKind::structure);
  Entity posts = site.entity(name + " posts", EntityKind::structure);
  for (int i = 0; i < panes; ++i) {
    const double start = from + i * step;
    pane.parts.push_back(Site::block("pane", start + kPost / 2, start + step - kPost / 2,
                                     kPaneThickness, 0.0, kDoorHeight, glass));
  }
  for (int i = 0; i <= panes; ++i) {
    const double at = from + i * step;
    posts.parts.push_back(
        Site::block("post", at - kPost / 2, at + kPost / 2, kPost, 0.0, kDoorHeight, metal));
  }
  site.world.entities.push_back(std::move(pane));
  site.world.entities.push_back(std::move(posts));
}

}  // namespace

double frame_width(OpeningKind kind) {
  return kind == OpeningKind::door ? kFramePost : 0.0;
}

void add_wall(World& world, const Wall& wall) {
  const Eigen::Vector2d way = wall.to - wall.from;
  const Site site{world,
                  wall,
                  {wall.from.x(), wall.from.y(), std::atan2(way.y(), way.x())},
                  way.norm(),
                  material_index(world, wall.material)};
  std::vector<Opening> openings = wall.openings;
  std::sort(openings.begin(), openings.end(),
            [](const Opening& a, const Opening& b) { return a.at < b.at; });

  Entity solid = site.entity(wall.name, EntityKind::structure);
  // Ends reach round the corner, so that two walls that meet leave no notch.
  double done = -wall.thickness / 2;
  int number = 0;
  for (const Opening& opening : openings) {
    const double from = opening.at - opening.width / 2;
    const double to = opening.at + opening.width / 2;
    // The frame stands in the hole, not in the wall: no two surfaces in one place.
    const double frame = frame_width(opening.kind);
    CHECK(from - frame >= done && to + frame <= site.length + wall.thickness / 2);
    if (from - frame - done > kThinnest) {
      solid.parts.push_back(Site::block("wall", done, from - frame, wall.thickness, 0.0,
                                        world.ceiling, site.material));
    }
    if (opening.kind != OpeningKind::gap && world.ceiling - kDoorHeight - frame > kThinnest) {
      solid.parts.push_back(Site::block("lintel", from - frame, to + frame, wall.thickness,
                                        kDoorHeight + frame, world.ceiling, site.material));
    }
    const std::string name = wall.name + " " + std::to_string(++number);
    if (opening.kind == OpeningKind::door) add_door(site, name + " door", from, to, opening.door);
    if (opening.kind == OpeningKind::glass) add_panes(site, name + " glass", from, to);
    done = to + frame;
  }
  const double end = site.length + wall.thickness / 2;
  if (end - done > kThinnest) {
    solid.parts.push_back(
        Site::block("wall", done, end, wall.thickness, 0.0, world.ceiling, site.material));
  }
  world.entities.push_back(std::move(solid));
}

void add_walls_around(World& world, const std::string& name, const Eigen::Vector2d& low,
                      const Eigen::Vector2d& high, double thickness, const std::string& material) {
  const Eigen::Vector2d east{high.x(), low.y()};
  const Eigen::Vector2d west{low.x(), high.y()};
  add_wall(world, {name + " south", low, east, thickness, material});
  add_wall(world, {name + " east", east, high, thickness, material});
  add_wall(world, {name + " north", high, west, thickness, material});
  add_wall(world, {name + " west", west, low, thickness, material});
}

void add_floor(World& world, const Eigen::Vector2d& low, const Eigen::Vector2d& high,
               const std::string& material) {
  constexpr double kThickness = 0.1;
  const Eigen::Vector2d size = high - low;
  const Eigen::Vector2d middle = (low + high) / 2;
  world.entities.push_back(
      {.name = "floor",
       .kind = EntityKind::floor,
       .world_from_entity = upright({middle.x(), middle.y(), 0.0}, -kThickness / 2),
       .parts = {{.name = "floor",
                  .geometry = Box{{size.x(), size.y(), kThickness}},
                  .material = material_index(world, material)}}});
}

}  // namespace mapbed
