#pragma once

#include <string>
#include <vector>

#include "core/geometry/trajectory.h"
#include "sim/actors/moving_pose.h"
#include "sim/truth/beam_truth.h"
#include "sim/truth/true_read.h"
#include "worlds/geometry/shape.h"

namespace mapbed {

// What an entity id in the truth stands for.
struct TruthEntity {
  int id = 0;
  std::string name;
  EntityKind kind = EntityKind::structure;
  std::vector<std::string> parts;

  // People, doors, vehicles, robots and movables can move; all else stands still for good.
  bool is_dynamic() const;
};

// A tag where it truly is.
struct TruthTag {
  std::string id;
  Pose3 world_from_tag;  // looks along x, its dipole lies along y
  int material = -1;     // that it sticks on, index into the materials; -1: nothing
};

// What holds for a whole recording.
struct TruthHeader {
  std::string world;
  std::string robot;
  std::vector<TruthEntity> entities;   // by id: those that a beam can meet, the robot last
  std::vector<std::string> materials;  // by index
  std::vector<TruthTag> tags;          // by index
};

// Where everything that can move was at one moment.
struct StampedStates {
  double time = 0.0;  // [s] as in the log
  Pose2 world_from_robot;
  std::vector<MovingPose> moving;  // every part of everything that can move but the robot
};

// Nothing of this is for algorithms: only metrics may read it.
struct Truth : TruthHeader {
  std::vector<StampedStates> states;   // at the scans' stamps, by time
  std::vector<BeamTruthOfScan> beams;  // one for each scan, by time
  std::vector<TruthRead> reads;        // of RFID tags, by time; drawn with the log's noise
};

Trajectory trajectory_of(const Truth& truth);  // world_from_robot at every scan's stamp

// Of the scan with this stamp by this laser; null where there is none.
const BeamTruthOfScan* beams_of(const Truth& truth, double time, int laser);

}  // namespace mapbed
