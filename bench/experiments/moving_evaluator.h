#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/estimator.h"
#include "algorithms/grid/map_builder.h"
#include "bench/metrics/cells_by_cause.h"
#include "bench/metrics/clear_mot.h"
#include "bench/metrics/label_error.h"
#include "bench/metrics/tracking_frame.h"
#include "bench/metrics/who_counts.h"
#include "bench/results/results.h"
#include "bench/sources/run_input.h"

namespace mapbed {

struct TrackingMetricOptions {
  double match_distance = 0.75;  // [m]
  double range = 8.0;            // [m]
  int least_beams = 2;
  double longest_occlusion = 3.0;  // [s]
};

template <class Visitor>
void visit_fields(TrackingMetricOptions& o, Visitor&& visit) {
  visit("match_distance", o.match_distance, Unit::meter, kPositive,
        "at most between a person and the track that follows him");
  visit("range", o.range, Unit::meter, kPositive,
        "of the robot, in which a tracker is to find him");
  visit("least_beams", o.least_beams, between(1, 1000), "of a scan on him, for that");
  visit("longest_occlusion", o.longest_occlusion, Unit::second, kPositive,
        "that a track is to survive; who was out of view for longer is somebody new");
}

// What a run says of what moves, against the truth of a simulated recording. A metric is NaN where
// nobody knows the truth, or where the method says nothing of it.
class MovingEvaluator {
 public:
  // All of these must outlive the evaluator; `world_from_robot` is the path of the estimate in the
  // world's frame, `map` made of it.
  MovingEvaluator(const TrackingMetricOptions& options, const MapOptions& map_options,
                  const RunInput& input, const Estimate& estimate,
                  const Trajectory& world_from_robot, const OccupancyMap& map);

  const LabelErrors* labels();  // null: there are none
  const SpuriousCells* spurious();
  double called_dynamic() const;   // fraction of the beams with a label, whatever they met
  double lost();                   // fraction of the true cells
  const TrackingFrames* frames();  // in which everybody counts
  const ClearMot* mot();
  double occlusions_kept();
  const std::vector<double>& iterations(const std::string& name) const;  // empty: there are none

  double match_distance() const { return options_.match_distance; }

  // The values of the wanted metrics of the table below.
  std::vector<std::pair<std::string, double>> values();

 private:
  bool has_truth() const;
  const TrackingFrames* all_frames();  // with those who do not count
  TrackingFrames frames_with_all() const;
  WhoCountsOptions who_counts() const;

  TrackingMetricOptions options_;
  const MapOptions& map_options_;
  const RunInput& input_;
  const Estimate& estimate_;
  const Trajectory& world_from_robot_;
  const OccupancyMap& map_;
  std::optional<TrueCauses> causes_;
  std::optional<LabelErrors> labels_;
  std::optional<SpuriousCells> spurious_;
  std::optional<TrackingFrames> all_frames_;
  std::optional<TrackingFrames> frames_;
  std::optional<ClearMot> mot_;
};

// Name, unit and meaning of all that a MovingEvaluator can tell.
std::vector<Metric> moving_metrics();

}  // namespace mapbed
