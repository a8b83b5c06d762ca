#include "sim/simulation.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include <fmt/format.h>

#include "core/check.h"
#include "core/input_error.h"
#include "sim/physics/planar_physics.h"
#include "sim/scene/scene.h"
#include "sim/sensors/ideal_laser.h"
#include "sim/sensors/rfid/rfid_field.h"
#include "worlds/geometry/footprint.h"

namespace mapbed {
namespace {

constexpr double kOverTheFloor = 0.02;  // [m] what is lower is walked and driven over
constexpr double kHeadHeight = 1.9;     // [m] people walk under what is higher
constexpr double kMostHistory = 5e8;    // [bytes]

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

MovingPose between(const MovingPose& a, const MovingPose& b, double fraction) {
  MovingPose result = b;
  if (a.world_from_part == b.world_from_part) return result;
  result.world_from_part = interpolate(a.world_from_part, b.world_from_part, fraction);
  return result;
}

Situation between(const Situation& a, const Situation& b, double fraction) {
  Situation result;
  result.time = a.time + fraction * (b.time - a.time);
  result.robot = interpolate(a.robot, b.robot, fraction);
  result.wheels = interpolate(a.wheels, b.wheels, fraction);
  result.motors = b.motors;
  result.moving.reserve(b.moving.size());
  for (std::size_t i = 0; i < b.moving.size(); ++i) {
    result.moving.push_back(between(a.moving[i], b.moving[i], fraction));
  }
  return result;
}

Obstacle circle_around(const Robot& robot, const Pose2& pose, const Twist2& velocity) {
  const double c = std::cos(pose.theta);
  const double s = std::sin(pose.theta);
  return {.pose = pose,
          .velocity = {c * velocity.forward - s * velocity.left,
                       s * velocity.forward + c * velocity.left},
          .radius = robot.footprint.reach()};
}

// How things move at one moment, by entity and part.
class Motions {
 public:
  Motions(std::size_t entities, const std::vector<MovingPose>& moving)
      : moving_(moving), first_(entities, kNone) {
    for (std::size_t i = moving.size(); i-- > 0;) {
      first_[static_cast<std::size_t>(moving[i].entity)] =
          i - static_cast<std::size_t>(moving[i].part);
    }
  }

  Motion of(int entity, int part) const {
    if (entity < 0) return Motion::still;
    const std::size_t first = first_[static_cast<std::size_t>(entity)];
    return first == kNone ? Motion::still : moving_[first + static_cast<std::size_t>(part)].motion;
  }

 private:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  const std::vector<MovingPose>& moving_;
  std::vector<std::size_t> first_;  // place of each entity's first part in moving_
};

}  // namespace

struct Simulation::State {
  State(const World& w, const Robot& r, const Pose2& start, const SimulationOptions& o,
        const Rng& rng)
      : world(w),
        robot(r),
        lasers(lasers_of(r)),
        rfid(world, antennas_of(r)),
        options(o),
        map(world, kOverTheFloor, robot.height),
        physics(world, robot, start, rng.stream("robot")),
        actors(make_actors(world, NavigationMap(world, kOverTheFloor, kHeadHeight),
                           circle_around(robot, start, {}), options.actors, rng)),
        scene(world) {
    double longest = 0.0, latest_stamp = 0.0;  // [s] after the first beam
    for (const MountedLaser& laser : lasers) {
      longest = std::max(longest, laser.model.sweep_time());
      latest_stamp = std::max(latest_stamp, laser.model.stamp_delay());
    }
    // A sweep that is over waits for those that were stamped before.
    history_length = std::max(history_length, longest + latest_stamp + options.step);
    for (const auto& actor : actors) {
      for (const Entity& entity : actor->entities()) scene.add(entity);
      actor->append_obstacles(obstacles);
    }
    for (const Obstacle& obstacle : obstacles) bodies.push_back(physics.add(obstacle));
    take_note();
    check_history();
  }

  void step(const DriveCommand& command);
  void move_actors();
  void take_note();
  void check_history() const;
  void arrange_scene(const Situation& situation);
  std::vector<std::vector<AimedBeam>> beams_by_slice(const LaserModel& laser, const Pose2& first,
                                                     const Pose2& last) const;

  World world;
  Robot robot;
  std::vector<MountedLaser> lasers;
  RfidField rfid;
  SimulationOptions options;
  NavigationMap map;
  PlanarPhysics physics;
  std::vector<std::unique_ptr<Actor>> actors;
  std::vector<Obstacle> obstacles;  // of all actors, one after the other
  std::vector<int> bodies;          // in physics, of each obstacle
  Scene scene;
  std::int64_t steps = 0;
  Situation now;
  double history_length = 0.2;                                      // [s] no sweep takes longer
  std::deque<Situation> history;                                    // oldest first, `now` last
  double arranged_time = std::numeric_limits<double>::quiet_NaN();  // what the scene shows
};

void Simulation::State::take_note() {
  now.time = options.step * static_cast<double>(steps);
  now.robot = physics.robot();
  now.wheels = physics.wheels().odometry();
  now.motors = physics.wheels().motors();
  now.moving.clear();
  for (const auto& actor : actors) actor->append_poses(now.moving);
  history.push_back(now);
  while (history.front().time < now.time - history_length - options.step) history.pop_front();
}

// A slow mirror keeps everything that moves for the length of its sweep.
void Simulation::State::check_history() const {
  const double moments = history_length / options.step;
  const double bytes = static_cast<double>(sizeof(Situation)) +
                       static_cast<double>(sizeof(MovingPose) * now.moving.size());
  if (moments * bytes <= kMostHistory) return;
  throw InputError(fmt::format(
      "a sweep takes {:.3g} s, and to remember for so long where everything was takes {:.2g} GB; "
      "raise mirror_rate or simulation.step, or ask for fewer people",
      history_length, moments * bytes / 1e9));
}

// One group after the other; each sees where those before it have gone.
void Simulation::State::move_actors() {
  const Obstacle view = circle_around(robot, physics.robot(), physics.robot_velocity());
  std::vector<Obstacle> moved;
  std::size_t next = 0;
  for (const auto& actor : actors) {
    actor->step(options.step, {view, obstacles});
    moved.clear();
    actor->append_obstacles(moved);
    for (const Obstacle& obstacle : moved) {
      physics.move(bodies[next], obstacle.pose);
      obstacles[next++] = obstacle;
    }
  }
  CHECK(next == obstacles.size());
}

// Who moves by itself goes first, then the robot drives among them.
void Simulation::State::step(const DriveCommand& command) {
  move_actors();
  physics.step(command, options.step);
  ++steps;
  take_note();
}

void Simulation::State::arrange_scene(const Situation& situation) {
  if (situation.time == arranged_time) return;
  arranged_time = situation.time;
  for (const MovingPose& p : situation.moving) scene.move(p.entity, p.part, p.world_from_part);
  scene.update();
}

// Beams by the slice of the sweep that they are sent in; within one only the robot moves, from
// `first` to `last` in the whole sweep.
std::vector<std::vector<AimedBeam>> Simulation::State::beams_by_slice(const LaserModel& laser,
                                                                      const Pose2& first,
                                                                      const Pose2& last) const {
  const double duration = laser.sweep_time();
  const int slices = duration > 0.0 ? options.sweep_slices : 1;
  std::vector<std::vector<AimedBeam>> result(static_cast<std::size_t>(slices));
  for (int k = 0; k < laser.beams; ++k) {
    const double fraction = duration > 0.0 ? laser.beam_delay(k) / duration : 0.0;
    const int slice = std::min(slices - 1, static_cast<int>(fraction * slices));
    result[static_cast<std::size_t>(slice)].push_back({k, interpolate(first, last, fraction)});
  }
  return result;
}

Simulation::Simulation(const World& world, const Robot& robot, const Pose2& start,
                       const SimulationOptions& options, const Rng& rng) {
  check_start(world, robot, start);
  state_ = std::make_unique<State>(world, robot, start, options, rng);
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
const NavigationMap& Simulation::navigation_map() const {
  return state_->map;
}
const Situation& Simulation::now() const {
  return state_->now;
}
std::span<const Obstacle> Simulation::obstacles() const {
  return state_->obstacles;
}
std::optional<Touch> Simulation::touched() const {
  return state_->physics.touched();
}
const Entity& Simulation::entity(int id) const {
  return state_->scene.entity(id);
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

Simulation::Sweep Simulation::sweep(int laser_index, double start, std::uint64_t number) {
  State& s = *state_;
  CHECK(laser_index >= 0 && static_cast<std::size_t>(laser_index) < s.lasers.size());
  const MountedLaser& laser = s.lasers[static_cast<std::size_t>(laser_index)];
  const double duration = laser.model.sweep_time();

  std::vector<BeamEchoes> echoes(static_cast<std::size_t>(laser.model.beams));
  const std::vector<std::vector<AimedBeam>> slices =
      s.beams_by_slice(laser.model, at(start).robot, at(start + duration).robot);
  for (std::size_t slice = 0; slice < slices.size(); ++slice) {
    const double fraction = (static_cast<double>(slice) + 0.5) / static_cast<double>(slices.size());
    s.arrange_scene(at(start + fraction * duration));
    std::vector<BeamEchoes> found = cast_beams(s.scene, laser, slices[slice]);
    for (std::size_t i = 0; i < found.size(); ++i) {
      echoes[static_cast<std::size_t>(slices[slice][i].index)] = std::move(found[i]);
    }
  }

  const Situation middle = at(start + duration / 2.0);
  const Motions motions(s.scene.entity_count(), middle.moving);
  const double stamp = at(start + laser.model.stamp_delay()).time;
  Sweep result;
  result.truth.time = result.ideal.time = stamp;
  result.truth.laser = result.ideal.laser = laser_index;
  result.ideal.sweep = number;
  // All at once: a long recording keeps thousands of these.
  std::size_t echo_count = 0;
  for (const BeamEchoes& beam : echoes) echo_count += beam.echoes.size();
  result.ideal.echoes.reserve(echo_count);
  result.ideal.first_echo.reserve(echoes.size() + 1);
  result.truth.beams.reserve(echoes.size());
  result.ideal.first_echo.push_back(0);
  for (BeamEchoes& beam : echoes) {
    beam.truth.motion = motions.of(beam.truth.entity, beam.truth.part);
    result.truth.beams.push_back(beam.truth);
    result.ideal.echoes.insert(result.ideal.echoes.end(), beam.echoes.begin(), beam.echoes.end());
    result.ideal.first_echo.push_back(static_cast<std::uint32_t>(result.ideal.echoes.size()));
  }
  return result;
}

IdealRfid Simulation::rfid_round(int antenna, double time, std::uint64_t number) {
  State& s = *state_;
  const Situation situation = at(time);
  s.arrange_scene(situation);
  IdealRfid round = s.rfid.round(s.scene, antenna, situation.robot);
  round.time = situation.time;
  round.round = number;
  return round;
}

TruthHeader Simulation::truth_header() const {
  const State& s = *state_;
  TruthHeader header;
  header.world = s.world.name;
  header.robot = s.robot.name;
  for (std::size_t id = 0; id < s.scene.entity_count(); ++id) {
    const Entity& entity = s.scene.entity(static_cast<int>(id));
    TruthEntity& truth = header.entities.emplace_back();
    truth.id = static_cast<int>(id);
    truth.name = entity.name;
    truth.kind = entity.kind;
    for (const Part& part : entity.parts) truth.parts.push_back(part.name);
  }
  header.entities.push_back(
      {static_cast<int>(header.entities.size()), s.robot.name, EntityKind::robot, {}});
  for (const Material& m : s.world.materials) header.materials.push_back(m.name);
  for (const RfidTag& tag : s.world.tags) {
    header.tags.push_back({tag.id, tag.world_from_tag, tag.material});
  }
  return header;
}

}  // namespace mapbed
