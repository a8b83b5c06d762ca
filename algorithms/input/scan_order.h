#pragma once

#include <cstddef>
#include <vector>

#include "algorithms/remark.h"
#include "core/log/sensor_log.h"

namespace mapbed {

// Two scans of one laser, one after the other, that have each other's stamps.
struct SwappedScans {
  std::size_t first = 0, second = 0;  // positions in the log
  TimeInterval when;                  // their stamps
};

// Messages that overtake one another get their stamps in the wrong order. While the robot moves,
// such scans do not fit on their neighbours where odometry has the robot at their stamps, and do
// fit where each is put to the other one's stamp. Told only where that is beyond doubt: between
// the scans the robot must have moved by more than odometry and beams err, by some centimetres or
// degrees. In order of time; without odometry none.
std::vector<SwappedScans> swapped_scans(const SensorLog& log);

// Each of the scans gets its own stamp.
SensorLog in_order(SensorLog log, const std::vector<SwappedScans>& swapped);

// Times in their words are counted from `start` [s].
std::vector<Remark> remarks_on(const std::vector<SwappedScans>& swapped, double start);

}  // namespace mapbed
