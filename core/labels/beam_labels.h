#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "core/log/sensor_log.h"

namespace mapbed {

// What a method believes of the beams of one scan: for each the probability that what it met
// belongs to the place and does not move, E[c] of (4.8) and 1 - q of (3.10). It says nothing of how
// many dimensions the laser looks into.
struct ScanLabels {
  double time = 0.0;  // [s] as in the log
  int laser = 0;
  std::vector<float> static_probability;  // kNoLabel: met nothing, or nothing is known
};

constexpr float kNoLabel = std::numeric_limits<float>::quiet_NaN();

// Of a scan of which nothing is known yet.
inline ScanLabels unlabelled(const LaserScan& scan) {
  return {scan.time, scan.laser, std::vector<float>(scan.ranges.size(), kNoLabel)};
}

// One for each scan that a method took in, in the order of the log.
using BeamLabels = std::vector<ScanLabels>;

// More likely than not; never of a beam without label.
inline bool is_dynamic(float static_probability) {
  return static_probability < 0.5F;
}

inline bool is_dynamic(const ScanLabels& labels, std::size_t beam) {
  return is_dynamic(labels.static_probability[beam]);
}

// Of scans that were fused (LaserScan::parts): labels of each laser's own scan, as it was recorded.
// `log` has the scans that are labelled, by the same stamps and in the same order, and perhaps
// further ones.
BeamLabels labels_of_lasers(const BeamLabels& labels, const SensorLog& log);

// The scan with those beams failed that are dynamic. Labels of as many beams.
LaserScan without_dynamic_beams(LaserScan scan, const ScanLabels& labels);

// The log without what the beams that are dynamic measured: these count as failed. Labels of each
// laser's own scan; scans without labels stay as they are.
SensorLog without_dynamic_beams(SensorLog log, const BeamLabels& labels_of_lasers);

}  // namespace mapbed
