#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "robots/laser_model.h"
#include "worlds/world.h"

namespace mapbed {

// What a single beam is sent at. The laser stands at (0, y), y anywhere in [-half_width,
// half_width], and looks along x.
struct LaserTarget {
  // A wall seen from above, without end but where `below` says so.
  struct Flat {
    double distance = 0.0;   // [m] where it crosses the x axis
    double incidence = 0.0;  // [rad] between the x axis and its normal
    std::string material;
    bool below = false;  // only y < 0: it ends in an edge on the x axis
  };
  struct Round {
    double distance = 0.0;  // [m] of its axis
    double radius = 0.0;    // [m]
    std::string material;
  };
  std::vector<Flat> flats;
  std::vector<Round> rounds;
  double half_width = 0.0;  // [m]
};

LaserTarget wall_target(const std::string& material, double distance, double incidence);
LaserTarget glass_target(double distance, double incidence, double gap);  // and a wall behind
LaserTarget edge_target(const LaserModel& laser, double distance, double gap);
LaserTarget leg_target(const LaserModel& laser, double distance, double radius, double gap);

// For the simulator.
World world_of(const LaserTarget& target);

// For the specification: plane geometry, nothing of the simulator.
struct Meeting {
  double range = 0.0;  // [m]
  double cos_incidence = 1.0;
  Eigen::Vector2d normal;  // towards the laser
  int surface = 0;         // flats first, then rounds
  std::string material;
};

// All that a line from `origin` along the unit vector `direction` meets, by increasing range.
std::vector<Meeting> meetings(const LaserTarget& target, const Eigen::Vector2d& origin,
                              const Eigen::Vector2d& direction);

}  // namespace mapbed
