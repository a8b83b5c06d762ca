#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/config/option.h"
#include "core/random.h"
#include "sim/actors/gait.h"
#include "sim/actors/social_force.h"
#include "worlds/world.h"

namespace mapbed {

struct CrowdOptions {
  int walkers = -1;            // -1: as many as the world says
  int standing = -1;           // -1: as above
  int blockers = -1;           // -1: as above
  double mean_speed = 1.1;     // [m/s] drawn for each person, between 0.4 and 1.8
  double speed_sigma = 0.2;    // [m/s]
  double block_time = 8.0;     // [s] a blocker stands in the robot's way
  double block_pause = 25.0;   // [s] and goes his own way in between
  double robot_margin = 0.15;  // [m] added to the robot's outline when people keep off it
  SocialForceOptions force = {};
};

template <class Visitor>
void visit_fields(CrowdOptions& o, Visitor&& visit) {
  visit("walkers", o.walkers, at_least(-1), "people who walk the world's routes; -1: its own");
  visit("standing", o.standing, at_least(-1), "people who stand at its places; -1: its own");
  visit("blockers", o.blockers, at_least(-1), "people who block the robot; -1: its own");
  visit("mean_speed", o.mean_speed, Unit::meter_per_second, kPositive, "wished walking speed");
  visit("speed_sigma", o.speed_sigma, Unit::meter_per_second, kNotNegative, "its spread");
  visit("block_time", o.block_time, Unit::second, kPositive, "how long a blocker stands");
  visit("block_pause", o.block_pause, Unit::second, kPositive, "and how long he does not");
  visit("robot_margin", o.robot_margin, Unit::meter, kNotNegative,
        "distance that people keep from the robot's outline");
  visit("force", o.force, "how people move");
}

// So many people all together, divided as the world divides its own between those who walk, stand
// and block; where it has nobody, all walk.
CrowdOptions with_people(CrowdOptions options, const CrowdRules& rules, int people);

enum class PersonKind : int { walker, standing, blocker };

// A person as others see it.
struct PersonView {
  PersonKind kind;
  Pose2 pose;                           // world_from_body, x where it looks
  Eigen::Vector2d velocity;             // [m/s]
  double radius;                        // [m]
  bool is_moving;                       // walks now, faster than 0.1 m/s
  std::array<Eigen::Vector2d, 2> legs;  // [m] in the body frame
};

// The robot as people see it.
struct RobotView {
  Pose2 pose;
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  // [m/s]
  double radius = 0.3;                                 // [m]
};

// Everybody who is about: who they are is drawn at the start, person by person from a stream of its
// own; then they walk their routes, pause, keep together in pairs, stand, or block the robot.
class Crowd {
 public:
  // Throws InputError where the world has no routes or places for the people asked for, or where
  // they do not fit.
  Crowd(const World& world, const FloorPlan& plan, const RobotView& robot,
        const CrowdOptions& options, const Rng& rng);
  ~Crowd();
  Crowd(Crowd&&) noexcept;
  Crowd& operator=(Crowd&&) noexcept;

  // dt [s] is divided into steps of 5 ms or less.
  void step(const RobotView& robot, std::span<const Wall> doors, double dt);

  std::size_t size() const;
  PersonView person(std::size_t index) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mapbed
