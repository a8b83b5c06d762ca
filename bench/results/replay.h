#pragma once

// A run to be watched in a browser: one scrubs through time and sees the world, the people, what
// the laser says, the estimate and the truth. The player is page/replay.js.
//
// The JSON, in metres, seconds since `start` and radians, numbers as short as the picture allows:
//
//   {"title": "...", "start": 0, "end": 60.5,
//    "outlines": [[x, y, x, y, ...], ...],
//    "map": {"png": "data:...", "x": 0, "y": 0, "width": 12, "height": 9},   low corner, size
//    "truth": TRACK, "estimate": TRACK, "odometry": TRACK,  {"t": [], "x": [], "y": [], "a": []}
//    "others": [{"name": "person 1", "kind": "person", "radius": 0.25, "t": [], ...}],
//    "scans": [{"t": 0.2, "laser": [x, y, angle], "first": -1.57, "step": 0.035, "cm": [...]},
//    ...]}
//
// where cm are ranges in centimetres at bearings first + k * step, 0 where nothing was hit, and
// laser is robot_from_laser.
//
// Everything but scans stands in one frame, the world's; whatever is not there is left out.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/trajectory.h"
#include "core/image/image.h"
#include "core/labels/beam_labels.h"
#include "core/labels/tracks.h"
#include "core/log/sensor_log.h"
#include "sim/truth/truth.h"
#include "worlds/world.h"

namespace mapbed {

struct ReplayPicture {
  RgbImage image;                                        // empty: none
  Eigen::Vector2d low_corner = Eigen::Vector2d::Zero();  // [m] of the lower left pixel
  double resolution = 0.05;                              // [m] per pixel
};

struct ReplayTrack {
  std::string name;
  std::string kind;      // "person", "door", "vehicle"
  double radius = 0.25;  // [m] of the disc that is drawn
  Trajectory world_from_it;
};

struct Replay {
  std::string title;
  std::vector<std::vector<Eigen::Vector2d>> outlines;  // [m] of what stands still
  ReplayPicture map;                                   // under everything
  Trajectory truth;                                    // world_from_robot
  Trajectory estimate;  // the same, in the world's frame: aligned by who gives it
  Trajectory odometry;
  std::vector<ReplayTrack> others;
  std::vector<LaserScan> scans;  // drawn at the robot's estimated, else its true pose
  BeamLabels labels = {};        // of them, by stamp and laser; without some, these tell nothing
  Tracks tracks = {};            // who is followed, in the world's frame as the estimate is
};

struct ReplayOptions {
  int max_steps = 1500;  // poses of a track; more are thinned evenly
  int max_scans = 600;   // thinned evenly
  int max_beams = 90;    // of a scan; of more, only every n-th is kept
};

std::string replay_json(const Replay& replay, const ReplayOptions& options = {});

// What a recording knows: poses, whatever moves, and the front laser's scans of `log`.
Replay replay_of(const Truth& truth, const SensorLog& log);

std::vector<LaserScan> front_scans_of(const SensorLog& log);

// Of what stands still in a world and reaches to this height [m]: closed lines.
std::vector<std::vector<Eigen::Vector2d>> outlines_of(const World& world, double height = 0.3);

// [m] of where it is held to be, along the longer axis.
double sigma_of(const TrackState& state);

// In another frame.
Tracks transformed(Tracks tracks, const Pose2& target_from_source);

// The estimate moved so that its first pose that the truth knows lies on the true one.
Trajectory aligned_at_start(const Trajectory& estimate, const Trajectory& truth);

}  // namespace mapbed
