#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/random.h"
#include "worlds/world.h"

namespace mapbed {

// A straight piece of a corridor, with round ends.
struct CorridorPiece {
  Eigen::Vector2d from, to;  // [m] middle line
  double width = 3.0;        // [m] in the mean
};

// How far a wall stands back from where a smooth one would be: a Gaussian field over the plane, of
// waves between 1.5 and 6 m long.
class WallRelief {
 public:
  WallRelief(double sigma, Rng& rng);                // [m]
  double at(const Eigen::Vector2d& position) const;  // [m]

 private:
  struct Wave {
    Eigen::Vector2d wave_number;  // [rad/m]
    double phase;                 // [rad]
  };
  double amplitude_;  // [m]
  std::vector<Wave> waves_;
};

// Walls round all that the pieces cover together, as thin slabs whose faces follow the relief
// within about `step` [m].
void add_rough_walls(World& world, const std::string& name,
                     const std::vector<CorridorPiece>& pieces, const WallRelief& relief,
                     const std::string& material, double step = 0.5);

}  // namespace mapbed
