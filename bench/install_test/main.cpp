#include <cmath>
#include <iostream>

#include "core/geometry/pose2.h"
#include "core/random.h"

// Drives a square with a little noise and says how far from its start it ends.
int main() {
  mapbed::Rng rng(7);
  mapbed::Pose2 world_from_robot;
  for (int side = 0; side < 4; ++side) {
    const double turn = std::acos(0.0) + rng.normal(0.0, 1e-4);
    world_from_robot = world_from_robot * mapbed::Pose2{1.0, 0.0, turn};
  }
  const double gap = mapbed::distance(world_from_robot, mapbed::Pose2{});
  std::cout << "gap " << gap << " m\n";
  return gap < 0.01 ? 0 : 1;
}
