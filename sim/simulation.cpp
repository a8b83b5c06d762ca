#include "sim/simulation.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include <fmt/format.h>

#include "core/check.h"
#include "core/geometry/angle.h"
#include "core/input_error.h"
#include "sim/actors/doors.h"
#include "sim/actors/person_body.h"
#include "sim/physics/planar_physics.h"
#include "sim/scene/scene.h"
#include "worlds/geometry/footprint.h"

namespace mapbed {
namespace {

constexpr double kOverTheFloor = 0.02;   // [m] what is lower is walked and driven over
constexpr double kHeadHeight = 1.9;      // [m] people walk under what is higher
constexpr double kLeafThickness = 0.04;  // [m]

void check_start(const World& world, const Robot& robot, const Pose2& start) {
  for (const Footprint& f : footprints(world, kOverTheFloor, robot.height)) {
    const Entity& entity = world.entities[static_cast<std::size_t>(f.entity)];
    if (entity.kind == EntityKind::floor || entity.kind == EntityKind::door) continue;
    if (distance_to(f, start.position()) >= robot.footprint.inner_radius()) continue;
    throw InputError(fmt::format(
        "robot '{}' starts inside an obstacle: '{}' of world '{}' stands at ({:.2f} m, {:.2f} m); "
        "start it elsewhere",
        robot.name, entity.name, world.name, start.x, start.y));
  }
}

double between(double a, double b, double share) {
  return a + share * (b - a);
}

PersonView between(const PersonView& a, const PersonView& b, double share) {
  PersonView result = b;
  result.pose = interpolate(a.pose, b.pose, share);
  for (std::size_t leg = 0; leg < 2; ++leg) {
    result.legs[leg] = a.legs[leg] + share * (b.legs[leg] - a.legs[leg]);
  }
  return result;
}

Situation between(const Situation& a, const Situation& b, double share) {
  Situation result = b;
  result.time = between(a.time, b.time, share);
  result.robot = interpolate(a.robot, b.robot, share);
  result.wheels = interpolate(a.wheels, b.wheels, share);
  for (std::size_t i = 0; i < b.people.size(); ++i) {
    result.people[i] = between(a.people[i], b.people[i], share);
  }
  for (std::size_t i = 0; i < b.leaves.size(); ++i) {
    result.leaves[i] = interpolate(a.leaves[i], b.leaves[i], share);
  }
  return result;
}

RobotView view_of(const Robot& robot, const Pose2& pose, const Twist2& velocity) {
  const double c = std::cos(pose.theta);
  const double s = std::sin(pose.theta);
  return {pose,
          {c * velocity.forward - s * velocity.left, s * velocity.forward + c * velocity.left},
          robot.footprint.reach()};
}

}  // namespace

struct Simulation::State {
  State(const World& w, const Robot& r, const Pose2& start, const SimulationOptions& o,
        const Rng& rng)
      : world(w),
        robot(r),
        options(o),
        plan(world, kOverTheFloor, robot.height),
        walking_plan(world, kOverTheFloor, kHeadHeight),
        physics(world, robot, start, rng.stream("robot")),
        doors(world, rng.stream("doors")),
        crowd(world, walking_plan, view_of(robot, start, {}), options.people, rng.stream("people")),
        scene(world) {
    for (const MountedLaser& laser : robot.lasers) {
      history_length = std::max(history_length, laser.model.sweep_time() + options.step);
    }
  }

  void add_bodies();
  void step(const DriveCommand& command);
  void take_note();
  void arrange_scene(const Situation& situation);
  std::vector<bool> note_tracked(const Situation& situation, TruthScan& truth) const;

  World world;
  Robot robot;
  SimulationOptions options;
  FloorPlan plan;
  FloorPlan walking_plan;
  PlanarPhysics physics;
  Doors doors;
  Crowd crowd;
  Scene scene;
  std::vector<int> person_entities;
  std::vector<int> person_bodies;  // in physics
  std::vector<int> leaf_bodies;
  std::int64_t steps = 0;
  Situation now;
  double history_length = 0.2;                                      // [s] no sweep takes longer
  std::deque<Situation> history;                                    // oldest first, `now` last
  double arranged_time = std::numeric_limits<double>::quiet_NaN();  // what the scene shows
};

void Simulation::State::add_bodies() {
  for (std::size_t i = 0; i < doors.size(); ++i) {
    leaf_bodies.push_back(
        physics.add_door(doors.world_from_leaf(i), doors.door(i).width, kLeafThickness));
  }
  const int clothes = crowd.size() > 0 ? material_index(world, "clothes") : 0;
  for (std::size_t i = 0; i < crowd.size(); ++i) {
    const PersonView person = crowd.person(i);
    person_bodies.push_back(physics.add_person(person.pose.position(), person.radius));
    person_entities.push_back(
        scene.add(person_entity(fmt::format("person {}", i + 1), person, clothes)));
  }
}

void Simulation::State::take_note() {
  now.time = options.step * static_cast<double>(steps);
  now.robot = physics.robot();
  now.wheels = physics.wheels().odometry();
  now.motors = physics.wheels().motors();
  now.people.clear();
  for (std::size_t i = 0; i < crowd.size(); ++i) now.people.push_back(crowd.person(i));
  now.leaves.clear();
  now.leaves_moving.clear();
  for (std::size_t i = 0; i < doors.size(); ++i) {
    now.leaves.push_back(doors.world_from_leaf(i));
    now.leaves_moving.push_back(doors.is_moving(i));
  }
  history.push_back(now);
  while (history.front().time < now.time - history_length - options.step) history.pop_front();
}

// People and doors go first, then the robot drives among them.
void Simulation::State::step(const DriveCommand& command) {
  const double dt = options.step;
  const RobotView view = view_of(robot, physics.robot(), physics.robot_velocity());
  if (doors.size() > 0) {
    std::vector<DoorVisitor> visitors{{view.pose.position(), view.radius}};
    for (const PersonView& p : now.people) visitors.push_back({p.pose.position(), p.radius});
    doors.step(visitors, dt);
    for (std::size_t i = 0; i < doors.size(); ++i) {
      physics.move(leaf_bodies[i], doors.world_from_leaf(i));
    }
  }
  crowd.step(view, doors.walls(), dt);
  for (std::size_t i = 0; i < crowd.size(); ++i) {
    const Pose2 pose = crowd.person(i).pose;
    physics.move(person_bodies[i], {pose.x, pose.y, 0.0});
  }
  physics.step(command, dt);
  ++steps;
  take_note();
}

void Simulation::State::arrange_scene(const Situation& s) {
  if (s.time == arranged_time) return;
  arranged_time = s.time;
  for (std::size_t i = 0; i < s.people.size(); ++i) {
    const PersonView& person = s.people[i];
    scene.move(person_entities[i], upright(person.pose));
    scene.move_part(person_entities[i], kLeftLeg, entity_from_leg(person.legs[0]));
    scene.move_part(person_entities[i], kRightLeg, entity_from_leg(person.legs[1]));
  }
  for (std::size_t i = 0; i < s.leaves.size(); ++i) {
    scene.move(doors.door(i).entity, upright(s.leaves[i]));
  }
  scene.update();
}

Simulation::Simulation(const World& world, const Robot& robot, const Pose2& start,
                       const SimulationOptions& options, const Rng& rng) {
  check_start(world, robot, start);
  state_ = std::make_unique<State>(world, robot, start, options, rng);
  state_->add_bodies();
  state_->take_note();
}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::step(const DriveCommand& command) {
  state_->step(command);
}

const World& Simulation::world() const {
  return state_->world;
}
const Robot& Simulation::robot() const {
  return state_->robot;
}
const FloorPlan& Simulation::floor_plan() const {
  return state_->plan;
}
const Situation& Simulation::now() const {
  return state_->now;
}
bool Simulation::is_touching() const {
  return state_->physics.is_touching();
}

Situation Simulation::at(double time) const {
  const std::deque<Situation>& history = state_->history;
  CHECK(time >= history.front().time - 1e-9 && time <= history.back().time + 1e-9);
  const auto after = std::lower_bound(history.begin(), history.end(), time,
                                      [](const Situation& s, double t) { return s.time < t; });
  if (after == history.begin()) return history.front();
  if (after == history.end()) return history.back();
  const Situation& a = *(after - 1);
  return between(a, *after, (time - a.time) / (after->time - a.time));
}

// Beams by the slice of the sweep that they are sent in; within one only the robot moves.
std::vector<std::vector<AimedBeam>> Simulation::beams_by_slice(const LaserModel& laser,
                                                               double start) const {
  const double duration = laser.sweep_time();
  const int slices = duration > 0.0 ? state_->options.sweep_slices : 1;
  const Pose2 first = at(start).robot;
  const Pose2 last = at(start + duration).robot;
  std::vector<std::vector<AimedBeam>> result(static_cast<std::size_t>(slices));
  for (int k = 0; k < laser.beams; ++k) {
    const double share = duration > 0.0 ? laser.beam_delay(k) / duration : 0.0;
    const int slice = std::min(slices - 1, static_cast<int>(share * slices));
    result[static_cast<std::size_t>(slice)].push_back({k, interpolate(first, last, share)});
  }
  return result;
}

// Who moves, by entity; what is tracked is noted in the truth.
std::vector<bool> Simulation::State::note_tracked(const Situation& s, TruthScan& truth) const {
  std::vector<bool> moves(scene.entity_count(), false);
  for (std::size_t i = 0; i < s.people.size(); ++i) {
    const int entity = person_entities[i];
    moves[static_cast<std::size_t>(entity)] = s.people[i].is_moving;
    truth.tracked.push_back({entity, s.people[i].pose, s.people[i].is_moving});
  }
  for (std::size_t i = 0; i < s.leaves.size(); ++i) {
    const int entity = doors.door(i).entity;
    moves[static_cast<std::size_t>(entity)] = s.leaves_moving[i];
    truth.tracked.push_back({entity, s.leaves[i], s.leaves_moving[i]});
  }
  return moves;
}

Simulation::Sweep Simulation::sweep(int laser_index, double start, std::uint64_t number) {
  State& s = *state_;
  CHECK(laser_index >= 0 && static_cast<std::size_t>(laser_index) < s.robot.lasers.size());
  const MountedLaser& laser = s.robot.lasers[static_cast<std::size_t>(laser_index)];
  const double duration = laser.model.sweep_time();

  std::vector<BeamEchoes> echoes(static_cast<std::size_t>(laser.model.beams));
  const std::vector<std::vector<AimedBeam>> slices = beams_by_slice(laser.model, start);
  for (std::size_t slice = 0; slice < slices.size(); ++slice) {
    const double share = (static_cast<double>(slice) + 0.5) / static_cast<double>(slices.size());
    s.arrange_scene(at(start + share * duration));
    std::vector<BeamEchoes> found = cast_beams(s.scene, laser, slices[slice]);
    for (std::size_t i = 0; i < found.size(); ++i) {
      echoes[static_cast<std::size_t>(slices[slice][i].index)] = std::move(found[i]);
    }
  }

  const Situation middle = at(start + duration / 2.0);
  Sweep result;
  result.truth.time = result.ideal.time = middle.time;
  result.truth.laser = result.ideal.laser = laser_index;
  result.truth.world_from_robot = middle.robot;
  result.ideal.sweep = number;
  const std::vector<bool> moves = s.note_tracked(middle, result.truth);
  result.ideal.first_echo.push_back(0);
  for (BeamEchoes& beam : echoes) {
    const int entity = beam.truth.entity;
    beam.truth.is_moving = entity >= 0 && moves[static_cast<std::size_t>(entity)];
    result.truth.beams.push_back(beam.truth);
    result.ideal.echoes.insert(result.ideal.echoes.end(), beam.echoes.begin(), beam.echoes.end());
    result.ideal.first_echo.push_back(static_cast<std::uint32_t>(result.ideal.echoes.size()));
  }
  return result;
}

std::vector<TruthEntity> Simulation::entities() const {
  const State& s = *state_;
  std::vector<TruthEntity> result;
  for (std::size_t id = 0; id < s.scene.entity_count(); ++id) {
    const Entity& entity = s.scene.entity(static_cast<int>(id));
    TruthEntity& truth = result.emplace_back();
    truth.id = static_cast<int>(id);
    truth.name = entity.name;
    truth.kind = entity.kind;
    for (const Part& part : entity.parts) truth.parts.push_back(part.name);
  }
  result.push_back({static_cast<int>(result.size()), s.robot.name, EntityKind::robot, {}});
  return result;
}

}  // namespace mapbed
