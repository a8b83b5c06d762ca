#pragma once

#include <string>

#include "sim/simulation.h"

namespace mapbed {

// Notices that a robot does not get on.
class StuckWatch {
 public:
  explicit StuckWatch(double patience) : patience_(patience) {}  // [s] 0: it never is

  // Whether it has stood where it is for so long. Asked at every step; a driver that rests on
  // purpose is not stuck.
  bool is_stuck(const Situation& now, bool is_resting);
  double since() const { return since_; }  // [s]

 private:
  double patience_;
  double since_ = 0.0;
  Pose2 place_;
  bool has_begun_ = false;
};

// "stuck by 'column 3'", "stuck by somebody at (2.00 m, 1.50 m)": what the robot touches, else who
// stands near it; else that it touches nothing, and what is nearest.
std::string what_is_in_the_way(const Simulation& simulation);

}  // namespace mapbed
