#pragma once

#include "algorithms/visibility/batch_filter.h"
#include "core/config/option.h"

namespace mapbed {

struct EverFreeOptions {
  int scans = 3;
  double sensor_margin = 0.1;  // [m]
  double pose_margin = 0.1;    // [m]
  double resolution = 0.05;    // [m]
  BeamLimits beams{};
};

template <class Visitor>
void visit_fields(EverFreeOptions& o, Visitor&& visit) {
  visit("scans", o.scans, between(1, 1000),
        "in which a place was surely free, after which whatever is seen there is dynamic");
  visit("sensor_margin", o.sensor_margin, Unit::meter, kNotNegative,
        "before a hit, in which a place may not be free: the laser's error");
  visit("pose_margin", o.pose_margin, Unit::meter, kNotNegative,
        "about a place, that must be free too: the error of poses");
  visit("resolution", o.resolution, Unit::meter, between(0.005, 10.0), "side of a cell");
  visit("beams", o.beams, "which beams are used, and how far");
}

// No vote but a proof: a place that was surely free, and all about it, cannot be of the place, and
// whatever is ever seen there is dynamic, however seldom it was free (Duberg et al., DUFOMap, 2024,
// in the plane; Schmid et al., Dynablox, 2023, ask for the same while they go). Doors that opened
// once and chairs that were taken away are dynamic too.
class EverFree : public BatchFilter {
 public:
  explicit EverFree(const EverFreeOptions& options = {}) : options_(options) {}

 private:
  BeamLabels labels(std::span<const LaserScan> scans,
                    const Trajectory& map_from_robot) const override;

  EverFreeOptions options_;
};

// How far each beam of a scan clears its way [m]: up to the first place that some beam of the scan
// met within `pose_margin` beside it, less `sensor_margin`; 0 for beams that say nothing.
std::vector<double> cleared_lengths(const LaserScan& scan, const BeamLimits& limits,
                                    double sensor_margin, double pose_margin);

}  // namespace mapbed
