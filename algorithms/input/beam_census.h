#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "algorithms/remark.h"
#include "core/sensor/laser_scan.h"

namespace mapbed {

// Whether lasers have beams enough for methods that match scans, and whether many of them fail,
// here and there: neighbours that fail together may look at what gives no return.
class BeamCensus {
 public:
  void add(const LaserScan& scan);
  std::vector<Remark> remarks() const;

 private:
  struct Count {
    std::size_t scans = 0, beams = 0, failed = 0;
    std::size_t changes = 0;  // from a beam that failed to one that did not, or back
  };
  std::map<int, Count> lasers_;
};

}  // namespace mapbed
