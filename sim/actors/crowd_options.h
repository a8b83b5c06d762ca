#pragma once

#include "core/config/option.h"
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
  visit("walkers", o.walkers, between(-1, 5000), "people who walk the world's routes; -1: its own");
  visit("standing", o.standing, between(-1, 5000), "people who stand at its places; -1: its own");
  visit("blockers", o.blockers, between(-1, 5000), "people who block the robot; -1: its own");
  visit("mean_speed", o.mean_speed, Unit::meter_per_second, between(0.01, 10.0),
        "wished walking speed");
  visit("speed_sigma", o.speed_sigma, Unit::meter_per_second, between(0.0, 10.0), "its sigma");
  visit("block_time", o.block_time, Unit::second, between(0.01, 1e6), "how long a blocker stands");
  visit("block_pause", o.block_pause, Unit::second, between(0.01, 1e6), "and how long he does not");
  visit("robot_margin", o.robot_margin, Unit::meter, between(0.0, 10.0),
        "distance that people keep from the robot's outline");
  visit("force", o.force, "how people move");
}

// So many people all together, divided as the world divides its own between those who walk, stand
// and block; where it has nobody, all walk.
CrowdOptions with_people(CrowdOptions options, const CrowdRules& rules, int people);

}  // namespace mapbed
