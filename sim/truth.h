#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/trajectory.h"
#include "sim/sensors/ideal_laser.h"
#include "worlds/world.h"

namespace mapbed {

// What an entity id in the truth stands for.
struct TruthEntity {
  int id = 0;
  std::string name;
  EntityKind kind = EntityKind::structure;
  std::vector<std::string> parts;

  // People, doors, vehicles and robots can move; everything else stands still for good.
  bool is_dynamic() const;
};

// Where something that can move is.
struct TrackedPose {
  int entity = 0;
  Pose2 pose;              // world_from_entity
  bool is_moving = false;  // at this moment
};

// What was true when a sweep was taken.
struct TruthScan {
  double time = 0.0;  // [s] the scan's own stamp
  int laser = 0;
  Pose2 world_from_robot;            // at that stamp
  std::vector<TrackedPose> tracked;  // everything that can move, at that stamp
  std::vector<BeamTruth> beams;
};

// Nothing of this is for algorithms: only metrics may read it.
struct Truth {
  std::string world;
  std::string robot;
  std::vector<TruthEntity> entities;   // those that a beam can meet, the robot last
  std::vector<std::string> materials;  // by index
  std::vector<TruthScan> scans;        // by time
};

Trajectory trajectory_of(const Truth& truth);  // world_from_robot at every scan's stamp

// Text, gzipped where the path ends in .gz; see truth.cpp for the lines. load_truth throws
// InputError with file and line.
void write_truth(const std::string& path, const Truth& truth);
Truth load_truth(const std::string& path);
Truth parse_truth(const std::string& name, std::string_view text);
std::string truth_text(const Truth& truth);

}  // namespace mapbed
