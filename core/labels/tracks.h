#pragma once

#include <vector>

#include <Eigen/Core>

namespace mapbed {

// Where something that moves was at one moment, on the floor.
struct TrackState {
  double time = 0.0;                                         // [s] of a scan
  Eigen::Vector2d position = Eigen::Vector2d::Zero();        // [m] in the map
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();        // [m/s] in the map
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();  // [m^2] of the position
  bool occluded = false;  // nothing of it was seen: where it is is a prediction
};

// One thing that was followed, under one number from first to last.
struct ObjectTrack {
  int id = 0;
  std::vector<TrackState> states;  // by time, one for each scan in which it was held present
};

using Tracks = std::vector<ObjectTrack>;  // by id

}  // namespace mapbed
