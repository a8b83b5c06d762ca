#include "sim/render/render_simulation.h"

#include <array>
#include <cmath>

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

void place_leaves(World& world, const std::vector<Pose2>& leaves) {
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    const auto id = static_cast<std::size_t>(world.doors[i].entity);
    world.entities[id].world_from_entity = upright(leaves[i]);
  }
}

std::vector<Entity> people_of(World& world, const std::vector<PersonView>& people) {
  std::array<int, kShirts.size()> shirts{};
  for (std::size_t i = 0; i < shirts.size(); ++i) shirts[i] = add_color(world, kShirts[i]);
  const int trousers = add_color(world, {0.16, 0.18, 0.24});
  const int skin = add_color(world, {0.80, 0.62, 0.50});
  std::vector<Entity> entities;
  for (std::size_t i = 0; i < people.size(); ++i) {
    Entity person = person_entity("person", people[i], trousers);
    person.parts[kTrunk].material = shirts[i % shirts.size()];
    person.parts.push_back(upright_cylinder("head", {}, 0.11, 1.6, 1.84, skin));
    entities.push_back(std::move(person));
  }
  return entities;
}

// What the first laser sees at this moment; nothing before its first sweep is over.
std::vector<LaserFan> fans_of(Simulation& simulation) {
  const Robot& robot = simulation.robot();
  if (robot.lasers.empty()) return {};
  const MountedLaser& laser = robot.lasers[0];
  const double start = simulation.now().time - laser.model.sweep_time();
  if (start < 0.0) return {};
  const TruthScan scan = simulation.sweep(0, start, 0).truth;
  // Each beam from where the robot was when it was sent.
  const auto point = [&](const Pose2& world_from_robot, double range, double bearing) {
    const Eigen::Vector2d p = world_from_robot * laser.robot_from_laser *
                              Eigen::Vector2d(range * std::cos(bearing), range * std::sin(bearing));
    return Eigen::Vector3d(p.x(), p.y(), laser.height);
  };
  LaserFan fan{.origin = point(simulation.now().robot, 0.0, 0.0)};
  for (std::size_t k = 0; k < scan.beams.size(); ++k) {
    const Pose2 sent_from =
        simulation.at(start + laser.model.beam_delay(static_cast<int>(k))).robot;
    const double bearing =
        laser.model.first_bearing + static_cast<double>(k) * laser.model.bearing_step;
    const double range = scan.beams[k].range;
    fan.is_hit.push_back(range < laser.model.max_range);
    fan.ends.push_back(point(sent_from, std::min(range, laser.model.max_range), bearing));
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
  for (const MountedLaser& laser : robot.lasers) {
    entity.parts.push_back(upright_box("laser", laser.robot_from_laser, 0.15, 0.15,
                                       laser.height - 0.09, laser.height + 0.09, dark));
  }
  return entity;
}

RgbImage render_simulation(Painter& painter, Simulation& simulation, const RenderOptions& options) {
  World world = simulation.world();
  const Situation now = simulation.now();
  place_leaves(world, now.leaves);
  Guests guests;
  guests.fans = fans_of(simulation);
  guests.entities = people_of(world, now.people);
  const int red = add_color(world, {0.72, 0.12, 0.10});
  const int dark = add_color(world, {0.12, 0.12, 0.13});
  guests.entities.push_back(robot_entity(simulation.robot(), now.robot, red, dark));
  RenderOptions about_robot = options;
  if (options.reach > 0.0 && options.center.empty()) {
    about_robot.center = {now.robot.x, now.robot.y};
  }
  return render_world(painter, world, about_robot, guests);
}

}  // namespace mapbed
