#pragma once

#include <span>
#include <utility>
#include <vector>

#include "algorithms/beam_filter.h"
#include "algorithms/grid/cells_about.h"
#include "algorithms/scan/beam.h"
#include "algorithms/scan/beam_weights.h"
#include "core/check.h"

namespace mapbed {

// A filter that judges in the end, when all scans and their poses are known: no beam is weighed
// before.
class BatchFilter : public BeamFilter {
 public:
  void add(const Odometry& /*reading*/) override {}
  std::vector<float> add(const LaserScan& scan, std::span<const float> beam_weights) override {
    scans_.push_back(beam_weights.empty() ? scan : with_failed_beams(scan, beam_weights));
    return {};
  }
  FilterResult result(const Trajectory& map_from_robot) const override {
    CHECK(map_from_robot.size() == scans_.size());
    return {.labels = labels(scans_, map_from_robot), .tracks = {}, .remarks = {}};
  }

 private:
  virtual BeamLabels labels(std::span<const LaserScan> scans,
                            const Trajectory& map_from_robot) const = 0;

  std::vector<LaserScan> scans_;
};

// Of each beam that hit something, the largest static_probability(cell) of the cells that it may
// have ended in: the one that it does end in and those about it, for ranges and poses are no better
// known.
template <class Probability>
BeamLabels labels_of_ends(std::span<const LaserScan> scans, const Trajectory& map_from_robot,
                          const BeamLimits& limits, const GridFrame& frame,
                          Probability&& static_probability) {
  BeamLabels labels;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    ScanLabels& of_scan = labels.emplace_back(unlabelled(scans[i]));
    for_each_beam(scans[i], map_from_robot[i].pose, limits, [&](std::size_t n, const Beam& beam) {
      if (beam.hit) {
        of_scan.static_probability[n] =
            static_cast<float>(largest_about(frame.cell_of(beam.end), static_probability));
      }
    });
  }
  return labels;
}

}  // namespace mapbed
