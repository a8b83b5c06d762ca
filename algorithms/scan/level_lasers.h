#pragma once

#include <map>
#include <vector>

#include "algorithms/remark.h"
#include "core/sensor/laser_scan.h"

namespace mapbed {

// What a method in the plane takes in: the scans of level lasers. What a tilted one sees lies at
// another height with every range, so that its scans would be taken for walls that nobody passes.
class LevelLasers {
 public:
  // False for the scan of a laser that is left out, which is remembered.
  bool take(const LaserScan& scan);

  // One for each laser that was left out.
  std::vector<Remark> remarks() const;

 private:
  std::map<int, double> left_out_;  // by laser: the angle between its plane and the floor [rad]
};

}  // namespace mapbed
