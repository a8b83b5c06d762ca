#include "algorithms/people/leg_filter.h"

#include <algorithm>

#include "algorithms/scan/beam_weights.h"
#include "core/check.h"

namespace mapbed {
namespace {

constexpr float kOfALeg = 0.1F;  // probability that a leg that moved is something static
constexpr float kElsewhere = 0.95F;

}  // namespace

std::vector<float> LegFilter::add(const LaserScan& scan, std::span<const float> beam_weights) {
  const LaserScan believed = beam_weights.empty() ? scan : with_failed_beams(scan, beam_weights);
  // Which features moved is not known before the scan is aligned.
  const ScanSightings found = front_end_.add(believed, beam_weights);
  std::vector<float> weights(scan.ranges.size(), 1.0F);
  for (std::size_t i = 0; i < found.features.size(); ++i) {
    const LegFeature& leg = found.features[i];
    if (found.past.verdict(found.places[i]) != SeenBefore::free ||
        leg.quality < options_.least_quality)
      continue;
    for (std::size_t b = leg.first; b <= leg.last; ++b) weights[b] = 0.0F;
  }
  ScanLabels& labels = labels_.emplace_back(unlabelled(scan));
  for (std::size_t b = 0; b < weights.size(); ++b) {
    if (!believed.is_hit(b)) continue;
    labels.static_probability[b] = weights[b] > 0.0F ? kElsewhere : kOfALeg;
  }
  front_end_.remember(found, std::vector<bool>(scan.ranges.size(), false));
  return weights;
}

FilterResult LegFilter::result(const Trajectory& map_from_robot) const {
  CHECK(map_from_robot.size() == labels_.size());
  return {labels_, {}, {}};
}

}  // namespace mapbed
