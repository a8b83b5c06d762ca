#pragma once

#include <vector>

#include "algorithms/beam_filter.h"
#include "algorithms/people/front_end/people_front_end.h"
#include "core/config/option.h"

namespace mapbed {

struct LegFilterOptions {
  double least_quality = 0.3;
  PeopleFrontEndOptions front_end;
};

template <class Visitor>
void visit_fields(LegFilterOptions& o, Visitor&& visit) {
  visit("least_quality", o.least_quality, kFraction, "of a feature that is taken for a leg");
  visit("front_end", o.front_end, "from scans to features");
}

// What chapter 3 compares itself with in 3.4.3: features without a tracker. Beams of legs that
// moved are left out, nothing is predicted, and who is not seen as a feature stays in the map.
class LegFilter : public BeamFilter {
 public:
  explicit LegFilter(const LegFilterOptions& options)
      : options_(options), front_end_(options.front_end) {}

  void add(const Odometry& reading) override { front_end_.add(reading); }
  std::vector<float> add(const LaserScan& scan, std::span<const float> beam_weights) override;
  FilterResult result(const Trajectory& map_from_robot) const override;

 private:
  LegFilterOptions options_;
  PeopleFrontEnd front_end_;
  BeamLabels labels_;
};

}  // namespace mapbed
