#include "sim/render/render_simulation.h"

#include <array>
#include <cmath>
#include <map>

#include "core/geometry/angle.h"
#include "sim/actors/person_body.h"

namespace mapbed {
namespace {

const std::array<Eigen::Vector3d, 6> kShirts = {
    Eigen::Vector3d(0.75, 0.22, 0.17), Eigen::Vector3d(0.16, 0.38, 0.63),
    Eigen::Vector3d(0.93, 0.69, 0.20), Eigen::Vector3d(0.25, 0.53, 0.34),
    Eigen::Vector3d(0.47, 0.29, 0.52), Eigen::Vector3d(0.88, 0.88, 0.86)};
constexpr double kGround = 0.05;  // [m] under the robot's body

int add_color(World& world, const Eigen::Vector3d& color) {
  world.materials.push_back({.name = "picture", .color = color});
  return static_cast<int>(world.materials.size()) - 1;
}

Part upright_cylinder(const std::string& name, const Pose2& middle, double radius, double bottom,
                      double top, int material) {
  return {.name = name,
          .geometry = Cylinder{radius, top - bottom},
          .entity_from_part = upright(middle, (bottom + top) / 2),
          .material = material};
}

Part upright_box(const std::string& name, const Pose2& middle, double length, double width,
                 double bottom, double top, int material) {
  return {.name = name,
          .geometry = Box{{length, width, top - bottom}},
          .entity_from_part = upright(middle, (bottom + top) / 2),
          .material = material};
}

// Those that move by themselves: what is the world's goes to its place there, the others come
// besides.
std::vector<Entity> placed_entities(const Simulation& simulation, World& world) {
  std::map<int, Entity> others;
  for (const MovingPose& moving : simulation.now().moving) {
    const auto id = static_cast<std::size_t>(moving.entity);
    Entity& entity =
        id < world.entities.size()
            ? world.entities[id]
            : others.try_emplace(moving.entity, simulation.entity(moving.entity)).first->second;
    entity.world_from_entity = {};
    entity.parts[static_cast<std::size_t>(moving.part)].entity_from_part = moving.world_from_part;
  }
  std::vector<Entity> entities;
  for (auto& [id, entity] : others) entities.push_back(std::move(entity));
  return entities;
}

// People get shirts and heads.
void dress(std::vector<Entity>& entities, World& world) {
  std::array<int, kShirts.size()> shirts{};
  for (std::size_t i = 0; i < shirts.size(); ++i) shirts[i] = add_color(world, kShirts[i]);
  const int trousers = add_color(world, {0.16, 0.18, 0.24});
  const int skin = add_color(world, {0.80, 0.62, 0.50});
  std::size_t next = 0;
  for (Entity& person : entities) {
    if (person.kind != EntityKind::person) continue;
    for (Part& part : person.parts) part.material = trousers;
    Part& trunk = person.parts[kTrunk];
    trunk.material = shirts[next++ % shirts.size()];
    const Pose2 middle = planar(trunk.entity_from_part);
    person.parts.push_back(upright_cylinder("head", middle, 0.11, 1.6, 1.84, skin));
  }
}

// What the first laser sees at this moment; nothing before its first sweep is over.
std::vector<LaserFan> fans_of(Simulation& simulation) {
  const std::vector<MountedLaser> lasers = lasers_of(simulation.robot());
  if (lasers.empty()) return {};
  const auto& [mount, laser] = lasers[0];
  const double start = simulation.now().time - laser.sweep_time();
  if (start < 0.0) return {};
  const std::vector<BeamTruth> beams = simulation.sweep(0, start, 0).truth.beams;
  // Each beam from where the robot was when it was sent.
  const Pose3 robot_from_laser = mount.pose();
  const auto point = [&](const Pose2& world_from_robot, double range, double bearing) {
    const Eigen::Vector3d in_laser(range * std::cos(bearing), range * std::sin(bearing), 0.0);
    return Eigen::Vector3d(upright(world_from_robot) * (robot_from_laser * in_laser));
  };
  LaserFan fan{.origin = point(simulation.now().robot, 0.0, 0.0)};
  for (std::size_t k = 0; k < beams.size(); ++k) {
    const Pose2 sent_from = simulation.at(start + laser.beam_delay(static_cast<int>(k))).robot;
    const double bearing = laser.first_bearing + static_cast<double>(k) * laser.bearing_step;
    const double range = beams[k].range;
    fan.is_hit.push_back(range < laser.max_range);
    fan.ends.push_back(point(sent_from, std::min(range, laser.max_range), bearing));
  }
  return {fan};
}

}  // namespace

Entity robot_entity(const Robot& robot, const Pose2& world_from_robot, int body, int dark) {
  Entity entity{.name = robot.name,
                .kind = EntityKind::robot,
                .world_from_entity = upright(world_from_robot)};
  const RobotFootprint& foot = robot.footprint;
  const double wheel = std::min(0.12, robot.height / 3);
  if (foot.radius > 0.0) {
    const double waist = 0.7 * robot.height;
    entity.parts = {upright_cylinder("wheels", {}, 0.85 * foot.radius, 0.0, kGround, dark),
                    upright_cylinder("body", {}, foot.radius, kGround, waist, body),
                    upright_cylinder("top", {}, 0.92 * foot.radius, waist, robot.height, dark)};
  } else {
    entity.parts = {
        upright_box("body", {}, foot.length, 0.8 * foot.width, kGround, robot.height, body)};
    for (const double side : {-0.45, 0.45}) {
      entity.parts.push_back(upright_box("wheels", {0.0, side * foot.width, 0.0}, 0.8 * foot.length,
                                         0.1 * foot.width, 0.0, 2 * wheel, dark));
    }
  }
  for (const MountedLaser& laser : lasers_of(robot)) {
    entity.parts.push_back({.name = "laser",
                            .geometry = Box{{0.15, 0.15, 0.18}},
                            .entity_from_part = laser.robot_from_laser.pose(),
                            .material = dark});
  }
  return entity;
}

RgbImage render_simulation(Painter& painter, Simulation& simulation, const RenderOptions& options) {
  World world = simulation.world();
  const Pose2 robot = simulation.now().robot;
  Visitors visitors;
  visitors.fans = fans_of(simulation);
  visitors.entities = placed_entities(simulation, world);
  dress(visitors.entities, world);
  const int red = add_color(world, {0.72, 0.12, 0.10});
  const int dark = add_color(world, {0.12, 0.12, 0.13});
  visitors.entities.push_back(robot_entity(simulation.robot(), robot, red, dark));
  RenderOptions about_robot = options;
  if (options.reach > 0.0 && options.center.empty()) about_robot.center = {robot.x, robot.y};
  return render_world(painter, world, about_robot, visitors);
}

}  // namespace mapbed
