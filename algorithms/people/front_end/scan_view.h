#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/sensor/laser_scan.h"

namespace mapbed {

// A scan as it is looked at from its lasers: which of its beams look towards a point.
class ScanView {
 public:
  // What one laser sees: its beams by ascending bearing.
  struct Eye {
    Eigen::Vector2d origin = Eigen::Vector2d::Zero();  // [m] in the robot frame
    std::vector<double> bearings;                      // [rad] in the robot frame, unwrapped
    std::size_t first_beam = 0;                        // of the scan
    bool is_reversed = false;                          // the scan counts them clockwise
    double step = 0.0;                                 // [rad] between neighbours, in the mean

    std::size_t size() const { return bearings.size(); }
    std::size_t beam(std::size_t i) const {
      return first_beam + (is_reversed ? size() - 1 - i : i);
    }
    // [rad] of a point, as its own bearings count.
    double bearing_of(const Eigen::Vector2d& point_in_robot) const;
    // Those whose bearing is within `aside` [rad] of one, as a half-open range.
    std::pair<std::size_t, std::size_t> within(double bearing, double aside) const;
  };

  explicit ScanView(LaserScan scan);

  const LaserScan& scan() const { return scan_; }
  const std::vector<Eye>& eyes() const { return eyes_; }

 private:
  LaserScan scan_;
  std::vector<Eye> eyes_;
};

}  // namespace mapbed
