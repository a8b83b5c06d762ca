#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "algorithms/field/likelihood_field.h"
#include "algorithms/grid/tiled_grid.h"
#include "core/geometry/pose2.h"
#include "core/sensor/laser_scan.h"

namespace mapbed {

// The ground that the scans of a local map looked over: what that map could know. A hit elsewhere
// is on nothing that the map holds wherever the robot is, and says nothing about that.
class ObservedGround {
 public:
  ObservedGround() : scans_(kCell) {}

  // What a scan looked over [m in the map frame], counter-clockwise or clockwise about the laser:
  // between two neighbouring beams as far as both of them went. Where only one did, the surface
  // that ended the other may go on.
  using Outline = std::vector<Eigen::Vector2d>;
  static Outline outline_of(const LaserScan& scan, double max_range, const Pose2& map_from_robot);

  void add(const Outline& outline) { count(outline, 1); }
  void remove(const Outline& outline) { count(outline, -1); }  // that was added before

  // Whether a hit [m in the map frame] of a beam from `laser` speaks for some poses and against
  // others, by what the map could know:
  //   - on opposite sides of it, some way off, the ground was looked over or carries a surface of
  //     `map`, so that the right pose can be told from those beside it. At the end of a wall that
  //     was seen in part it cannot: there a hit would speak for the poses behind the right one;
  //   - or the beam went through a surface, to ground behind it.
  bool knows_about(const Eigen::Vector2d& hit, const Eigen::Vector2d& laser,
                   const LikelihoodField& map) const;

 private:
  static constexpr double kCell = 0.1;  // [m]
  static constexpr double kAway = 0.3;  // [m]

  bool sees_both_sides(const Eigen::Vector2d& hit, const LikelihoodField& map) const;
  bool went_through(const Eigen::Vector2d& hit, const Eigen::Vector2d& laser,
                    const LikelihoodField& map) const;
  void count(const Outline& outline, int sign);

  TiledGrid<std::uint16_t> scans_;  // that looked over the middle of the cell
};

}  // namespace mapbed
