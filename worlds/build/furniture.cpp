#include "worlds/build/furniture.h"

#include <cmath>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

// An entity that parts are added to, by where they stand: middle in the plan, bottom and top.
class Piece {
 public:
  Piece(const World& world, const std::string& name, const Pose2& pose,
        EntityKind kind = EntityKind::furniture)
      : world_(world), entity_{.name = name, .kind = kind, .world_from_entity = upright(pose)} {}

  Piece& box(const std::string& name, const Pose2& middle, double width_x, double width_y,
             double bottom, double top, const std::string& material) {
    return add(name, Box{{width_x, width_y, top - bottom}}, middle, (bottom + top) / 2, material);
  }

  Piece& cylinder(const std::string& name, double x, double y, double radius, double bottom,
                  double top, const std::string& material) {
    return add(name, Cylinder{radius, top - bottom}, {x, y, 0.0}, (bottom + top) / 2, material);
  }

  // Four legs, the middles of which stand on the corners of a rectangle.
  Piece& legs(double length_x, double length_y, double radius, double top,
              const std::string& material) {
    for (const double x : {-length_x / 2, length_x / 2}) {
      for (const double y : {-length_y / 2, length_y / 2}) {
        cylinder("leg", x, y, radius, 0.0, top, material);
      }
    }
    return *this;
  }

  Entity done() const { return entity_; }

 private:
  Piece& add(const std::string& name, Geometry geometry, const Pose2& middle, double z,
             const std::string& material) {
    entity_.parts.push_back({.name = name,
                             .geometry = std::move(geometry),
                             .entity_from_part = upright(middle, z),
                             .material = material_index(world_, material)});
    return *this;
  }

  const World& world_;
  Entity entity_;
};

}  // namespace

Entity desk(const World& world, const Pose2& pose, double width, double depth) {
  return Piece(world, "desk", pose)
      .box("top", {}, depth, width, 0.71, 0.74, "wood")
      .legs(depth - 0.1, width - 0.1, 0.025, 0.71, "metal")
      .box("drawers", {-0.05, width / 2 - 0.32, 0.0}, depth - 0.2, 0.42, 0.1, 0.6, "metal")
      .box("screen", {-depth / 2 + 0.2, 0.0, 0.0}, 0.04, 0.5, 0.82, 1.15, "plastic")
      .box("stand", {-depth / 2 + 0.2, 0.0, 0.0}, 0.15, 0.2, 0.74, 0.82, "plastic")
      .done();
}

Entity table(const World& world, const Pose2& pose, double width, double depth) {
  return Piece(world, "table", pose)
      .box("top", {}, width, depth, 0.71, 0.75, "wood")
      .legs(width - 0.16, depth - 0.16, 0.03, 0.71, "metal")
      .done();
}

Entity office_chair(const World& world, const Pose2& pose) {
  Piece piece(world, "office chair", pose);
  for (int i = 0; i < 5; ++i) {
    const double angle = 2.0 * kPi * i / 5;
    const Pose2 foot{0.16 * std::cos(angle), 0.16 * std::sin(angle), angle};
    piece.box("foot", foot, 0.3, 0.04, 0.03, 0.1, "plastic");
  }
  return piece.cylinder("post", 0.0, 0.0, 0.03, 0.1, 0.44, "metal")
      .box("seat", {}, 0.48, 0.48, 0.44, 0.52, "fabric")
      .box("back", {-0.22, 0.0, 0.0}, 0.06, 0.44, 0.6, 1.05, "fabric")
      .done();
}

Entity chair(const World& world, const Pose2& pose) {
  return Piece(world, "chair", pose)
      .legs(0.38, 0.38, 0.015, 0.43, "metal")
      .box("seat", {}, 0.44, 0.44, 0.43, 0.47, "wood")
      .box("back", {-0.2, 0.0, 0.0}, 0.03, 0.42, 0.6, 0.9, "wood")
      .done();
}

Entity cabinet(const World& world, const Pose2& pose, double width, double depth, double height) {
  return Piece(world, "cabinet", pose)
      .box("body", {}, depth, width, 0.0, height, height > 1.5 ? "wood" : "metal")
      .done();
}

Entity bin(const World& world, const Pose2& pose) {
  return Piece(world, "bin", pose).cylinder("body", 0, 0, 0.2, 0.0, 0.65, "metal").done();
}

Entity plant(const World& world, const Pose2& pose) {
  return Piece(world, "plant", pose, EntityKind::plant)
      .cylinder("pot", 0, 0, 0.22, 0.0, 0.45, "stone")
      .cylinder("stem", 0, 0, 0.03, 0.45, 0.9, "wood")
      .cylinder("leaves", 0, 0, 0.35, 0.9, 1.3, "leaf")
      .cylinder("leaves", 0.05, 0, 0.22, 1.3, 1.6, "leaf")
      .done();
}

Entity bench(const World& world, const Pose2& pose, double length) {
  return Piece(world, "bench", pose)
      .box("seat", {}, 0.45, length, 0.38, 0.46, "wood")
      .box("foot", {0.0, -length / 2 + 0.2, 0.0}, 0.4, 0.08, 0.0, 0.38, "metal")
      .box("foot", {0.0, length / 2 - 0.2, 0.0}, 0.4, 0.08, 0.0, 0.38, "metal")
      .done();
}

Entity column(const World& world, const Pose2& pose, double radius, const std::string& material) {
  return Piece(world, "column", pose, EntityKind::structure)
      .cylinder("shaft", 0, 0, radius, 0.0, world.ceiling, material)
      .done();
}

Entity showcase(const World& world, const Pose2& pose, double width, double depth) {
  constexpr double kPane = 0.01;
  constexpr double kBase = 0.15;
  constexpr double kTop = 1.9;
  const double x = depth / 2 - kPane / 2;
  const double y = width / 2 - kPane / 2;
  Piece piece(world, "showcase", pose);
  piece.box("base", {}, depth, width, 0.0, kBase, "wood")
      .box("top", {}, depth, width, kTop, kTop + 0.1, "wood")
      .box("pane", {-x, 0, 0}, kPane, width, kBase, kTop, "glass")
      .box("pane", {x, 0, 0}, kPane, width, kBase, kTop, "glass")
      .box("pane", {0, -y, 0}, depth - 2 * kPane, kPane, kBase, kTop, "glass")
      .box("pane", {0, y, 0}, depth - 2 * kPane, kPane, kBase, kTop, "glass")
      .box("stand", {}, 0.4 * depth, 0.4 * width, kBase, 0.8, "fabric")
      .cylinder("exhibit", 0, 0, 0.15 * depth, 0.8, 1.2, "stone");
  return piece.done();
}

Entity pedestal(const World& world, const Pose2& pose, double width) {
  return Piece(world, "statue", pose)
      .box("base", {}, width, width, 0.0, 0.25, "stone")
      .box("pedestal", {}, 0.75 * width, 0.75 * width, 0.25, 1.0, "stone")
      .cylinder("figure", 0, 0, 0.2 * width, 1.0, 1.7, "stone")
      .cylinder("head", 0, 0, 0.11 * width, 1.7, 1.95, "stone")
      .done();
}

Entity rope_post(const World& world, const Pose2& pose) {
  return Piece(world, "rope post", pose)
      .cylinder("foot", 0, 0, 0.15, 0.0, 0.03, "metal")
      .cylinder("post", 0, 0, 0.03, 0.03, 0.95, "metal")
      .done();
}

}  // namespace mapbed
