#include "sim/render/render_world.h"

#include <algorithm>
#include <array>

#include "core/input_error.h"

namespace mapbed {
namespace {

const std::array<Eigen::Vector3d, 4> kPathColors = {
    Eigen::Vector3d(0.12, 0.47, 0.71), Eigen::Vector3d(1.0, 0.5, 0.05),
    Eigen::Vector3d(0.17, 0.63, 0.17), Eigen::Vector3d(0.58, 0.4, 0.74)};

PaintedMesh painted(const World& world, const RenderOptions& options, const Visitors& visitors) {
  PaintedMesh mesh;
  const PaintOptions paint_options{.cut_height = options.cut_height};
  for (const Entity& entity : world.entities) paint(mesh, entity, world.materials, paint_options);
  for (const Entity& entity : visitors.entities) paint(mesh, entity, world.materials);
  // A simulation has them among its visitors, where they are by then.
  for (const Movable& movable : world.movables) {
    if (visitors.entities.empty()) paint(mesh, movable.entity, world.materials);
  }
  for (const RfidTag& tag : world.tags) paint(mesh, tag);
  for (const LaserFan& fan : visitors.fans) paint(mesh, fan);
  for (std::size_t i = 0; options.paths && i < world.paths.size(); ++i) {
    std::vector<Eigen::Vector3d> points;
    // Each path a hair higher than the one before, so that neither flickers through the other.
    const double z = 0.01 + 0.004 * static_cast<double>(i);
    for (const WayPoint& p : world.paths[i].points) {
      points.emplace_back(p.position.x(), p.position.y(), z);
    }
    paint_line(mesh, points, 0.08, kPathColors[i % kPathColors.size()]);
  }
  return mesh;
}

// What the picture has to show.
Eigen::AlignedBox3d shown(const World& world, const RenderOptions& options) {
  Eigen::AlignedBox3d box = bounds_of(world);
  if (box.isEmpty()) throw InputError("world '" + world.name + "' has nothing to draw");
  if (options.cut_height > 0.0) box.max().z() = std::min(box.max().z(), options.cut_height + 0.5);
  if (!options.center.empty() && options.center.size() != 2) {
    throw InputError("a picture's center has two coordinates; write center=[x, y]");
  }
  Eigen::Vector2d middle = box.center().head<2>();
  if (!options.center.empty()) middle = Eigen::Vector2d(options.center[0], options.center[1]);
  if (options.reach > 0.0) {
    const Eigen::Vector2d reach = Eigen::Vector2d::Constant(options.reach);
    box.min().head<2>() = middle - reach;
    box.max().head<2>() = middle + reach;
  }
  return box;
}

}  // namespace

RgbImage render_world(const World& world, const RenderOptions& options, const Visitors& visitors) {
  Painter painter;
  return render_world(painter, world, options, visitors);
}

RgbImage render_world(Painter& painter, const World& world, const RenderOptions& options,
                      const Visitors& visitors) {
  const Eigen::AlignedBox3d box = shown(world, options);
  const double aspect = static_cast<double>(options.width) / options.height;
  const Camera camera = options.view == View::plan
                            ? plan_of(box, aspect)
                            : camera_on(box, options.azimuth, options.elevation, aspect);
  return painter.draw(painted(world, options, visitors), camera,
                      {.width = options.width,
                       .height = options.height,
                       .samples = options.samples,
                       .shadows = options.shadows});
}

}  // namespace mapbed
