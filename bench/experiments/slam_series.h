#pragma once

#include <optional>
#include <vector>

#include "algorithms/estimator.h"
#include "bench/results/series.h"
#include "bench/sources/run_input.h"

namespace mapbed {

// What a run of SLAM gives over its time: how far the robot's pose is off while it drives, and how
// many possibilities a particle filter holds.
const std::vector<SeriesMetric>& slam_series();

// Watches a method at work. Only what is wanted of slam_series() is worked out.
class SlamSeries {
 public:
  // A point every `step` [s] after the log's start, and one at its end. The input must outlive
  // this.
  SlamSeries(const RunInput& input, double step);

  // After each scan was added, of the time [s] of that scan.
  void look(double time, const Estimator& estimator);
  // After the last one. A series that neither the method nor the log can give is left out.
  std::vector<Series> finish(const Estimator& estimator);

 private:
  void add_error(double time, const Pose2& map_from_robot);

  const RunInput& input_;
  double step_;                          // [s]
  double start_;                         // [s] of the log
  double next_;                          // [s] when the next point is due
  std::optional<double> waiting_;        // [s] of the last look, where it gave no point
  std::optional<Pose2> world_from_map_;  // aligns the first poses
  Series position_error_;
};

// Of a method that searches data associations, those of slam_series() that are wanted.
std::vector<Series> series_of_associations(const Estimate& estimate, const RunInput& input);

// Of a method that iterates, those of slam_series() that are wanted.
std::vector<Series> series_of_iterations(const Estimate& estimate, const RunInput& input);

}  // namespace mapbed
