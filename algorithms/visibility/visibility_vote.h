#pragma once

#include "algorithms/visibility/batch_filter.h"
#include "core/config/option.h"

namespace mapbed {

struct VisibilityVoteOptions {
  double ratio = 5.0;
  double resolution = 0.05;  // [m]
  double end_margin = 0.1;   // [m]
  BeamLimits beams{};
};

template <class Visitor>
void visit_fields(VisibilityVoteOptions& o, Visitor&& visit) {
  visit("ratio", o.ratio, between(0.01, 1e6),
        "of scans that saw through a place to those that saw something there, above which what was "
        "seen is dynamic");
  visit("resolution", o.resolution, Unit::meter, between(0.005, 10.0), "side of a cell");
  visit("end_margin", o.end_margin, Unit::meter, kNotNegative,
        "the last stretch of a beam before its hit, which is no look through");
  visit("beams", o.beams, "which beams are used, and how far");
}

// Visibility by vote: of all scans that look at a cell, each votes once, for something static if a
// beam ends there and against it if beams pass through. In the plane, what point cloud maps are
// cleaned by (Pomerleau et al., 2014; Kim and Kim, Removert, 2020).
class VisibilityVote : public BatchFilter {
 public:
  explicit VisibilityVote(const VisibilityVoteOptions& options = {}) : options_(options) {}

 private:
  BeamLabels labels(std::span<const LaserScan> scans,
                    const Trajectory& map_from_robot) const override;

  VisibilityVoteOptions options_;
};

}  // namespace mapbed
