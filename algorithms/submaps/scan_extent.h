#pragma once

#include <vector>

#include "algorithms/submaps/point_motion.h"
#include "core/geometry/pose2.h"
#include "core/sensor/laser_scan.h"

namespace mapbed {

// What one scan says of a point.
enum class Seen : int {
  nothing,  // no beam went there, or it was behind what was hit
  free,     // beams went on beyond it
  surface,  // beams ended about there
};

// How far the beams of a scan went in each direction: small enough to keep for every scan of a long
// log. Beams of one sweep, or of several lasers, are taken as seen from where each laser was in the
// middle of them.
class ScanExtent {
 public:
  // Hits beyond `max_range` [m], and the ends of beams that hit nothing, tell of free ground before
  // them alone; of lasers that reach farther than `no_return_range` [m] a missing return says
  // nothing.
  ScanExtent(const LaserScan& scan, double max_range, double no_return_range);

  // Of a point in the robot frame [m], that is at a surface where it lies at most `margin` [m]
  // before or behind the end of the beams next to it: free or hidden only as both of them say.
  Seen at(const Eigen::Vector2d& point_in_robot, double margin) const;

 private:
  struct Direction {
    float range = 0.0F;  // [m] how far the ground was looked over; 0: no beam
    bool hit = false;    // and what is there was hit
  };
  struct Fan {  // of one laser
    PointMotion laser_from_robot;
    double first_bearing = 0.0, bearing_step = 1.0;  // [rad]
    double farthest = 0.0;                           // [m] of the directions
    std::vector<Direction> directions;
  };
  static double beams_from_first(const Fan& fan, double bearing);
  static double beam_at(const Fan& fan, const Eigen::Vector2d& point_in_laser);
  static Seen seen_by(const Fan& fan, const Eigen::Vector2d& point_in_robot, double margin);

  std::vector<Fan> fans_;
};

}  // namespace mapbed
