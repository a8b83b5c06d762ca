#include "bench/experiments/slam_series.h"

#include <cmath>
#include <string>

namespace mapbed {
namespace {

const std::string kPositionError = "position_error";
const std::string kEffectiveNumber = "effective_number";
const std::string kAncestors = "distinct_ancestors";
const std::string kNewest = "newest_log_likelihood";

// Of the updates those at which a point is due, and the last one.
Series thinned(const std::string& name, const std::vector<Diversity>& updates, double start,
               double step, double (*value)(const Diversity&)) {
  Series series{.name = name};
  double next = start;
  for (const Diversity& update : updates) {
    if (update.time < next && &update != &updates.back()) continue;
    series.points.push_back({update.time - start, value(update)});
    while (next <= update.time) next += step;
  }
  return series;
}

}  // namespace

const std::vector<SeriesMetric>& slam_series() {
  static const std::vector<SeriesMetric> table{
      {kPositionError, Unit::meter, "time", Unit::second,
       "distance of the robot's pose from the true one while it drives, the first poses aligned"},
      {kEffectiveNumber, Unit::none, "time", Unit::second,
       "effective number of particles at an update, before resampling"},
      {kAncestors, Unit::none, "time", Unit::second,
       "particles of an update that have descendants at the end"},
      {kNewest, Unit::none, "time", Unit::second,
       "of what the newest local map saw, under the data associations of the moment, Figure 6.3"},
      {"log_likelihood", Unit::none, "iteration", Unit::none,
       "of the beams and their causes, in expectation, (4.7)"},
      {"marginal_log_likelihood", Unit::none, "iteration", Unit::none,
       "of the beams, whatever their causes"},
  };
  return table;
}

SlamSeries::SlamSeries(const RunInput& input, double step)
    : input_(input),
      step_(step),
      start_(input.log.empty() ? 0.0 : time_of(input.log.front())),
      next_(start_),
      position_error_{.name = kPositionError} {}

void SlamSeries::look(double time, const Estimator& estimator) {
  if (input_.truth.empty() || !input_.wanted.contains(kPositionError)) return;
  waiting_ = time;
  if (time < next_) return;
  add_error(time, estimator.pose());
  while (next_ <= time) next_ += step_;
}

void SlamSeries::add_error(double time, const Pose2& map_from_robot) {
  waiting_.reset();
  const std::optional<Pose2> world_from_robot = pose_at(input_.truth, time);
  if (!world_from_robot) return;
  if (!world_from_map_) {  // no error here, by definition
    world_from_map_ = *world_from_robot * inverse(map_from_robot);
    return;
  }
  const double error = distance(*world_from_robot, *world_from_map_ * map_from_robot);
  position_error_.points.push_back({time - start_, error});
}

std::vector<Series> SlamSeries::finish(const Estimator& estimator) {
  if (waiting_) add_error(*waiting_, estimator.pose());
  std::vector<Series> all;
  if (!position_error_.points.empty()) all.push_back(position_error_);
  const bool wants_particles =
      input_.wanted.contains(kEffectiveNumber) || input_.wanted.contains(kAncestors);
  if (!wants_particles) return all;
  const std::vector<Diversity> updates = estimator.hypotheses().diversity;
  if (updates.empty()) return all;
  if (input_.wanted.contains(kEffectiveNumber)) {
    all.push_back(thinned(kEffectiveNumber, updates, start_, step_,
                          [](const Diversity& d) { return d.effective_number; }));
  }
  if (input_.wanted.contains(kAncestors)) {
    all.push_back(thinned(kAncestors, updates, start_, step_, [](const Diversity& d) {
      return static_cast<double>(d.distinct_ancestors);
    }));
  }
  return all;
}

std::vector<Series> series_of_associations(const Estimate& estimate, const RunInput& input) {
  if (!estimate.associations || !input.wanted.contains(kNewest)) return {};
  Series series{.name = kNewest};
  const double start = input.log.empty() ? 0.0 : time_of(input.log.front());
  for (const AssociationTree::Choice& choice : estimate.associations->choices) {
    if (std::isfinite(choice.newest)) series.points.push_back({choice.time - start, choice.newest});
  }
  return {series};
}

std::vector<Series> series_of_iterations(const Estimate& estimate, const RunInput& input) {
  std::vector<Series> all;
  for (const IterationValues& iterations : estimate.iterations) {
    if (!input.wanted.contains(iterations.name)) continue;
    Series& series = all.emplace_back(Series{.name = iterations.name});
    for (std::size_t i = 0; i < iterations.values.size(); ++i) {
      series.points.push_back({static_cast<double>(i), iterations.values[i]});
    }
  }
  return all;
}

}  // namespace mapbed
