#include <cmath>
#include <iostream>

#include "algorithms/methods.h"

// Drives a square by its odometry, scanning at each corner, and says how far from its start it
// ends.
int main() {
  const auto method = mapbed::method_by_name("odometry").configure({}).make({}, mapbed::Rng(7));
  mapbed::Odometry odometry;
  for (int corner = 0; corner <= 4; ++corner) {
    method->add(odometry);
    mapbed::LaserScan scan;
    scan.time = odometry.time;
    method->add(scan);
    const mapbed::Pose2 side_and_turn{1.0, 0.0, std::acos(0.0)};
    odometry.odometry_from_robot = odometry.odometry_from_robot * side_and_turn;
    odometry.time += 1.0;
  }
  const mapbed::Trajectory path = method->estimate().trajectory;
  const double gap = mapbed::distance(path.front().pose, path.back().pose);
  std::cout << path.size() << " poses, gap " << gap << " m\n";
  return path.size() == 5 && gap < 1e-9 ? 0 : 1;
}
