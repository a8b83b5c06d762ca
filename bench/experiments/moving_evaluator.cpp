#include "bench/experiments/moving_evaluator.h"

#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "algorithms/scan/scans_on_path.h"
#include "bench/experiments/labels_by_thing.h"
#include "bench/metrics/hota.h"
#include "bench/metrics/identity_f1.h"
#include "bench/metrics/occlusions.h"
#include "bench/metrics/ospa.h"
#include "core/image/map_server.h"
#include "sim/recording.h"

namespace mapbed {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double of_labels(MovingEvaluator& e, double (*value)(const LabelErrors&)) {
  const LabelErrors* errors = e.labels();
  return errors == nullptr ? kNone : value(*errors);
}

double of_cells(MovingEvaluator& e, long SpuriousCells::*count) {
  const SpuriousCells* cells = e.spurious();
  return cells == nullptr ? kNone : static_cast<double>(cells->*count);
}

template <class Value>
double of_tracks(MovingEvaluator& e, Value&& value) {
  const TrackingFrames* frames = e.frames();
  return frames == nullptr ? kNone : value(*frames);
}

double rise(const std::vector<double>& values) {
  return values.size() < 2 ? kNone : values.back() - values.front();
}

double least_step(const std::vector<double>& values) {
  double least = kNone;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double step = values[i] - values[i - 1];
    if (!(least <= step)) least = step;
  }
  return least;
}

struct EvaluatedMetric {
  Metric metric;
  double (*value)(MovingEvaluator&);
};

const std::vector<EvaluatedMetric>& evaluated_metrics() {
  using E = MovingEvaluator;
  using L = LabelErrors;
  using F = TrackingFrames;
  static const std::vector<EvaluatedMetric> table{
      {{"called_dynamic", Unit::none, "of beams that have a label, the fraction called dynamic"},
       [](E& e) { return e.called_dynamic(); }},
      {{"label_precision", Unit::none, "of beams called dynamic, the fraction that met a mover"},
       [](E& e) { return of_labels(e, [](const L& l) { return l.precision(); }); }},
      {{"label_recall", Unit::none,
        "of beams on what moves in the recording, the fraction called dynamic"},
       [](E& e) { return of_labels(e, [](const L& l) { return l.recall(); }); }},
      {{"recall_moving", Unit::none, "the same of those on what moves just then"},
       [](E& e) { return of_labels(e, [](const L& l) { return l.moving.fraction(); }); }},
      {{"recall_waiting", Unit::none, "the same of those on what moves at another time"},
       [](E& e) { return of_labels(e, [](const L& l) { return l.waiting.fraction(); }); }},
      {{"recall_people", Unit::none, "label_recall of people alone"},
       [](E& e) {
         return of_labels(e, [](const L& l) { return l.of_movers(EntityKind::person).fraction(); });
       }},
      {{"recall_doors", Unit::none, "label_recall of doors alone"},
       [](E& e) {
         return of_labels(e, [](const L& l) { return l.of_movers(EntityKind::door).fraction(); });
       }},
      {{"resting_removed", Unit::none,
        "of beams on what could move and never does, the fraction called dynamic"},
       [](E& e) { return of_labels(e, [](const L& l) { return l.resting.fraction(); }); }},
      {{"static_removed", Unit::none, "of beams on the place, the fraction called dynamic"},
       [](E& e) { return of_labels(e, [](const L& l) { return l.place.fraction(); }); }},
      {{"associated_accuracy", Unit::none,
        "root of (1 - static_removed) times label_recall, see label_error.h"},
       [](E& e) { return of_labels(e, [](const L& l) { return l.associated_accuracy(); }); }},
      {{"mover_cells", Unit::none,
        "cells that truly are free and that a map server is not told so, made by what moves in the "
        "recording"},
       [](E& e) { return of_cells(e, &SpuriousCells::of_movers); }},
      {{"people_cells", Unit::none, "of mover_cells those that people made, not doors"},
       [](E& e) { return of_cells(e, &SpuriousCells::of_people); }},
      {{"resting_cells", Unit::none, "as mover_cells, of what could move and never does"},
       [](E& e) { return of_cells(e, &SpuriousCells::of_resting); }},
      {{"lost_cells", Unit::none,
        "of the true occupied cells that a map server is not told to be free by a map of all "
        "beams, "
        "the fraction that it is told to be free by this one"},
       [](E& e) { return e.lost(); }},
      {{"mota", Unit::none, "multi-object tracking accuracy, see clear_mot.h"},
       [](E& e) { return e.mot() == nullptr ? kNone : e.mot()->accuracy(); }},
      {{"motp", Unit::meter, "mean distance of people and the tracks that follow them"},
       [](E& e) { return e.mot() == nullptr ? kNone : e.mot()->precision(); }},
      {{"identity_switches", Unit::none, "people who get another track, see clear_mot.h"},
       [](E& e) { return e.mot() == nullptr ? kNone : static_cast<double>(e.mot()->switches); }},
      {{"idf1", Unit::none, "see identity_f1.h"},
       [](E& e) {
         return of_tracks(e, [&](const F& f) { return identity_f1(f, e.match_distance()); });
       }},
      {{"hota", Unit::none, "see hota.h"},
       [](E& e) {
         return of_tracks(e, [&](const F& f) { return hota(f, e.match_distance()).hota; });
       }},
      {{"ospa", Unit::meter, "cut off at tracking.match_distance, see ospa.h"},
       [](E& e) {
         return of_tracks(e, [&](const F& f) { return mean_ospa(f, e.match_distance()); });
       }},
      {{"occlusions_kept", Unit::none,
        "fraction of the occlusions below tracking.longest_occlusion that a track survives"},
       [](E& e) { return e.occlusions_kept(); }},
      {{"likelihood_rise", Unit::none, "log_likelihood of the last iteration less the first one's"},
       [](E& e) { return rise(e.iterations("log_likelihood")); }},
      {{"marginal_rise", Unit::none, "the same of marginal_log_likelihood"},
       [](E& e) { return rise(e.iterations("marginal_log_likelihood")); }},
      {{"marginal_least_step", Unit::none,
        "least change of marginal_log_likelihood from one iteration to the next"},
       [](E& e) { return least_step(e.iterations("marginal_log_likelihood")); }},
  };
  return table;
}

}  // namespace

MovingEvaluator::MovingEvaluator(const TrackingMetricOptions& options,
                                 const MapOptions& map_options, const RunInput& input,
                                 const Estimate& estimate, const Trajectory& world_from_robot,
                                 const OccupancyMap& map)
    : options_(options),
      map_options_(map_options),
      input_(input),
      estimate_(estimate),
      world_from_robot_(world_from_robot),
      map_(map) {
  if (has_truth()) causes_.emplace(input.recording->truth);
}

bool MovingEvaluator::has_truth() const {
  return input_.recording != nullptr && !input_.recording->truth.beams.empty();
}

const LabelErrors* MovingEvaluator::labels() {
  if (!causes_ || !estimate_.labels) return nullptr;
  if (!labels_) labels_ = label_errors(*estimate_.labels, input_.log, *causes_);
  return &*labels_;
}

const SpuriousCells* MovingEvaluator::spurious() {
  if (!causes_ || !input_.true_map || world_from_robot_.empty()) return nullptr;
  if (!spurious_) {
    spurious_ =
        spurious_cells(map_, input_.true_map(map_options_.resolution), input_.log,
                       world_from_robot_, *causes_, {.occupied = MapServerThresholds{}.free});
  }
  return &*spurious_;
}

const std::vector<double>& MovingEvaluator::iterations(const std::string& name) const {
  static const std::vector<double> kNoValues;
  for (const IterationValues& iterations : estimate_.iterations) {
    if (iterations.name == name) return iterations.values;
  }
  return kNoValues;
}

double MovingEvaluator::called_dynamic() const {
  if (!estimate_.labels) return kNone;
  LabelCounts counts;
  for (const ScanLabels& of_scan : *estimate_.labels) {
    for (const float label : of_scan.static_probability) {
      if (std::isnan(label)) continue;
      ++counts.beams;
      if (is_dynamic(label)) ++counts.dynamic;
    }
  }
  return counts.fraction();
}

double MovingEvaluator::lost() {
  if (!input_.true_map || !estimate_.labels) return kNone;
  const OccupancyMap of_all = build_map(input_.log, world_from_robot_, map_options_);
  return lost_cells(of_all, map_, input_.true_map(map_options_.resolution),
                    {.occupied = MapServerThresholds{}.free});
}

// At the stamps of the estimate's poses. Tracks are placed by where they are seen from the robot,
// so that a path that is wrong on the whole does not count against them.
TrackingFrames MovingEvaluator::frames_with_all() const {
  std::map<double, const StampedStates*> states_at;
  for (const StampedStates& states : input_.recording->truth.states) {
    states_at[states.time] = &states;
  }
  std::map<double, std::vector<TrackedObject>> tracks_at;
  for (const ObjectTrack& track : *estimate_.tracks) {
    for (const TrackState& s : track.states) tracks_at[s.time].push_back({track.id, s.position});
  }
  TrackingFrames frames;
  for_each_scan_on_path(
      input_.log, estimate_.trajectory, [&](const LaserScan& scan, const Pose2& map_from_robot) {
        const auto states = states_at.find(scan.time);
        if (states == states_at.end()) return;
        const Pose2 world_from_map = states->second->world_from_robot * inverse(map_from_robot);
        TrackingFrame& frame = frames.emplace_back();
        frame.time = scan.time;
        frame.truth = people_at(scan, *states->second, input_.recording->truth, who_counts());
        for (const TrackedObject& track : tracks_at[scan.time]) {
          frame.tracks.push_back({track.id, world_from_map * track.position});
        }
      });
  return by_appearance(std::move(frames), who_counts());
}

WhoCountsOptions MovingEvaluator::who_counts() const {
  return {.range = options_.range,
          .least_beams = options_.least_beams,
          .longest_absence = options_.longest_occlusion};
}

const TrackingFrames* MovingEvaluator::all_frames() {
  if (!causes_ || !estimate_.tracks) return nullptr;
  if (!all_frames_) all_frames_ = frames_with_all();
  return &*all_frames_;
}

const TrackingFrames* MovingEvaluator::frames() {
  const TrackingFrames* all = all_frames();
  if (all != nullptr && !frames_) frames_ = counting_alone(*all, options_.match_distance);
  return all == nullptr ? nullptr : &*frames_;
}

const ClearMot* MovingEvaluator::mot() {
  const TrackingFrames* counting = frames();
  if (counting != nullptr && !mot_) mot_ = clear_mot(*counting, options_.match_distance);
  return counting == nullptr ? nullptr : &*mot_;
}

double MovingEvaluator::occlusions_kept() {
  const TrackingFrames* all = all_frames();
  if (all == nullptr) return kNone;
  return occlusions_in(
             *all, {.longest = options_.longest_occlusion, .max_distance = options_.match_distance})
      .fraction_kept();
}

std::vector<std::pair<std::string, double>> MovingEvaluator::values() {
  std::vector<std::pair<std::string, double>> values;
  for (const EvaluatedMetric& row : evaluated_metrics()) {
    if (!input_.wanted.contains(row.metric.name)) continue;
    values.emplace_back(row.metric.name, row.value(*this));
  }
  for (const ThingMetric& row : metrics_by_thing()) {
    if (!input_.wanted.contains(row.metric.name)) continue;
    const LabelErrors* errors = labels();
    values.emplace_back(
        row.metric.name,
        errors == nullptr ? kNone : fraction_called_dynamic(*errors, row, input_.recording->truth));
  }
  return values;
}

std::vector<Metric> moving_metrics() {
  std::vector<Metric> metrics;
  for (const EvaluatedMetric& row : evaluated_metrics()) metrics.push_back(row.metric);
  for (const ThingMetric& row : metrics_by_thing()) metrics.push_back(row.metric);
  return metrics;
}

}  // namespace mapbed
