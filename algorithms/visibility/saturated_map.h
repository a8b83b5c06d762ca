#pragma once

#include "algorithms/visibility/batch_filter.h"
#include "core/config/option.h"

namespace mapbed {

struct SaturatedMapOptions {
  double p_hit = 0.7;
  double p_pass = 0.4;
  double least = 0.1192;
  double most = 0.971;
  double resolution = 0.05;  // [m]
  double end_margin = 0.1;   // [m]
  BeamLimits beams{};
};

template <class Visitor>
void visit_fields(SaturatedMapOptions& o, Visitor&& visit) {
  visit("p_hit", o.p_hit, between(0.501, 0.999), "of a cell that a scan saw something in");
  visit("p_pass", o.p_pass, between(0.001, 0.499), "of a cell that a scan saw through");
  visit("least", o.least, between(0.001, 0.499), "that a cell is sure to be free, at most");
  visit("most", o.most, between(0.501, 0.999), "that a cell is sure to be occupied, at most");
  visit("resolution", o.resolution, Unit::meter, between(0.005, 10.0), "side of a cell");
  visit("end_margin", o.end_margin, Unit::meter, kNotNegative,
        "the last stretch of a beam before its hit, which is no look through");
  visit("beams", o.beams, "which beams are used, and how far");
}

// An occupancy map whose odds saturate (Yguel et al., 2008; Hornung et al., OctoMap, 2013), so that
// a place that changed is soon believed: what was seen where the map is free in the end was
// dynamic. Its defaults are OctoMap's.
class SaturatedMap : public BatchFilter {
 public:
  explicit SaturatedMap(const SaturatedMapOptions& options = {}) : options_(options) {}

 private:
  BeamLabels labels(std::span<const LaserScan> scans,
                    const Trajectory& map_from_robot) const override;

  SaturatedMapOptions options_;
};

}  // namespace mapbed
