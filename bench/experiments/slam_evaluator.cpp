#include "bench/experiments/slam_evaluator.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "bench/metrics/entropy.h"

namespace mapbed {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

struct EvaluatedMetric {
  Metric metric;
  double (*value)(SlamEvaluator&);
};

// None of methods that search no data associations.
template <class Value>
double of_search(const SlamEvaluator& evaluator, const Value& value) {
  const std::optional<AssociationTree>& tree = evaluator.estimate().associations;
  return tree ? static_cast<double>(value(*tree)) : kNone;
}

int revised_decisions(const AssociationTree& tree) {
  int changed = 0;
  for (const AssociationTree::Revision& revision : tree.revisions) changed += revision.changed;
  return changed;
}

const std::vector<EvaluatedMetric>& evaluated_metrics() {
  using E = SlamEvaluator;
  static const std::vector<EvaluatedMetric> table{
      {{"translation_error", Unit::meter, "ATE: RMS distance, after the best alignment"},
       [](E& e) { return e.absolute().translation.rmse; }},
      {{"rotation_error", Unit::radian, "ATE: RMS turn, after the best alignment"},
       [](E& e) { return e.absolute().rotation.rmse; }},
      {{"largest_error", Unit::meter, "largest distance, the first poses aligned"},
       [](E& e) { return e.largest_error(); }},
      {{"relative_translation", Unit::meter, "mean error over path_length of true path"},
       [](E& e) { return e.over_path().translation.mean; }},
      {{"relative_rotation", Unit::radian, "the same of the turn"},
       [](E& e) { return e.over_path().rotation.mean; }},
      {{"relations_translation", Unit::meter, "mean error over the measured relations"},
       [](E& e) { return e.relations().mean_translation; }},
      {{"relations_translation_spread", Unit::meter, "standard deviation of these errors"},
       [](E& e) { return e.relations().sigma_translation; }},
      {{"relations_rotation", Unit::radian, "mean error of the turn over the measured relations"},
       [](E& e) { return e.relations().mean_rotation; }},
      {{"relations_rotation_spread", Unit::radian, "standard deviation of these errors"},
       [](E& e) { return e.relations().sigma_rotation; }},
      {{"relations_compared", Unit::none, "relations that the estimate reaches"},
       [](E& e) { return e.relations_compared(); }},
      {{"log_error", Unit::meter,
        "relations_translation, or where nobody measured relations the same over near pairs of the "
        "poses that another program found, see pairs.h"},
       [](E& e) { return e.log_error(); }},
      {{"success", Unit::none,
        "1: largest_error is below success_distance, excess_doubled_walls below "
        "success_doubled_walls",
        0.0},
       [](E& e) { return e.success(); }},
      {{"failures", Unit::none, "1: largest_error is above failure_distance", 1.0},
       [](E& e) { return e.has_failed(); }},
      {{"map_f1", Unit::none, "of occupied cells against the world's own map, see map_error.h"},
       [](E& e) { return e.map_errors().f1(); }},
      {{"map_precision", Unit::none, "fraction of the occupied cells that are right"},
       [](E& e) { return e.map_errors().precision(); }},
      {{"map_recall", Unit::none, "fraction of the true occupied cells that were found"},
       [](E& e) { return e.map_errors().recall(); }},
      {{"spurious_cells", Unit::none, "occupied cells without a true one near"},
       [](E& e) { return e.spurious_cells(); }},
      {{"map_coverage", Unit::none, "fraction of the truly free cells that the map knows"},
       [](E& e) { return e.confusion().coverage(); }},
      {{"free_as_occupied", Unit::none, "fraction of the truly free cells it knows"},
       [](E& e) { return e.confusion().free_as_occupied(); }},
      {{"occupied_as_free", Unit::none, "fraction of the truly occupied cells it knows"},
       [](E& e) { return e.confusion().occupied_as_free(); }},
      {{"doubled_walls", Unit::none,
        "fraction of the true walls with one more near, "
        "see doubled_walls.h"},
       [](E& e) { return e.doubled_walls(); }},
      {{"excess_doubled_walls", Unit::none,
        "doubled_walls less those of the map of the same scans at their true poses"},
       [](E& e) { return e.excess_doubled_walls(); }},
      {{"sharpness", Unit::none,
        "[bit] minus the mean entropy of the known cells; a smeared map knows more of them, so it "
        "compares maps of one size"},
       [](E& e) { return -mean_entropy(e.map()); }},
      {{"untrusted_scans", Unit::none, "scans whose match was not trusted"},
       [](E& e) { return static_cast<double>(e.estimate().untrusted_scans); }},
      {{"revisions", Unit::none, "times that a search of data associations took some back"},
       [](E& e) {
         return of_search(e, [](const AssociationTree& t) { return t.revisions.size(); });
       }},
      {{"revised_decisions", Unit::none, "data associations that it took back, in all of them"},
       [](E& e) { return of_search(e, revised_decisions); }},
      {{"searches_given_up", Unit::none, "times that it ended before it was sure of the best"},
       [](E& e) { return of_search(e, [](const AssociationTree& t) { return t.given_up; }); }},
      {{"path_length", Unit::meter, "of the estimated path"},
       [](E& e) { return path_length(e.estimate().trajectory); }},
  };
  return table;
}

Trajectory transformed(const Trajectory& map_from_robot, const Pose2& world_from_map) {
  Trajectory result = map_from_robot;
  for (Stamped<Pose2>& stamped : result) stamped.pose = world_from_map * stamped.pose;
  return result;
}

// The true poses at the stamps of an estimate; none where one of them is not known.
Trajectory truth_at_stamps(const Trajectory& truth, const Trajectory& estimate) {
  Trajectory result;
  for (const Stamped<Pose2>& stamped : estimate) {
    const std::optional<Pose2> pose = pose_at(truth, stamped.time);
    if (!pose) return {};
    result.push_back({stamped.time, *pose});
  }
  return result;
}

// Of a value that is worked out once.
template <class Value, class Make>
const Value& once(std::optional<Value>& kept, Make&& make) {
  if (!kept) kept = make();
  return *kept;
}

}  // namespace

SlamEvaluator::SlamEvaluator(const EvaluationOptions& options, const RunInput& input,
                             const Estimate& estimate)
    : options_(options), input_(input), estimate_(estimate) {
  pairs_ = associated(input.truth, estimate.trajectory);
  if (!pairs_.empty()) world_from_map_ = alignment(pairs_);
  world_from_robot_ = transformed(estimate.trajectory, world_from_map_);
  absolute_ = absolute_error(pairs_, world_from_map_);
  over_path_ = error_over_path(input.truth, estimate.trajectory, options.path_length);
}

const OccupancyMap& SlamEvaluator::map() {
  return once(map_, [&] {
    return build_map(input_.log, world_from_robot_, options_.map, labels_in(estimate_));
  });
}

double SlamEvaluator::largest_error() const {
  if (pairs_.empty()) return kNone;
  double largest = 0.0;
  const Pose2 world_from_map = pairs_.front().truth * inverse(pairs_.front().estimate);
  for (const PosePair& pair : pairs_) {
    largest = std::max(largest, distance(pair.truth, world_from_map * pair.estimate));
  }
  return largest;
}

const RelationsError& SlamEvaluator::relations() {
  return once(relations_, [&] {
    const bool known = input_.relations && !estimate_.trajectory.empty();
    if (!known)
      return RelationsError{.mean_translation = kNone,
                            .sigma_translation = kNone,
                            .mean_rotation = kNone,
                            .sigma_rotation = kNone};
    const MeasuredRelations& measured = input_.relations();
    const bool linear = options_.relation_stamps == RelationStamps::linear;
    return relations_error(estimate_.trajectory, measured.relations,
                           linear ? Trajectory{} : measured.odometry);
  });
}

double SlamEvaluator::relations_compared() {
  return input_.relations ? relations().count : kNone;
}

double SlamEvaluator::log_error() {
  if (input_.relations || !input_.pairs) return relations().mean_translation;
  if (estimate_.trajectory.empty()) return kNone;
  return relations_error(estimate_.trajectory, input_.pairs()).mean_translation;
}

const MapErrors& SlamEvaluator::map_errors() {
  return once(map_errors_,
              [&] { return has_true_map() ? compare_maps(map(), true_map()) : MapErrors{}; });
}

double SlamEvaluator::spurious_cells() {
  return has_true_map() ? map_errors().spurious() : kNone;
}

const MapConfusion& SlamEvaluator::confusion() {
  return once(confusion_,
              [&] { return has_true_map() ? confusion_of(map(), true_map()) : MapConfusion{}; });
}

double SlamEvaluator::doubled_walls() {
  return once(doubled_walls_, [&] {
    if (!has_true_map()) return kNone;
    return mapbed::doubled_walls(map(), true_map(), options_.doubled).fraction();
  });
}

double SlamEvaluator::excess_doubled_walls() {
  return once(excess_doubled_walls_, [&] {
    if (!has_true_map()) return kNone;
    const Trajectory truth = truth_at_stamps(input_.truth, estimate_.trajectory);
    if (truth.empty()) return kNone;
    const OccupancyMap ideal = build_map(input_.log, truth, options_.map);
    return doubled_walls() - mapbed::doubled_walls(ideal, true_map(), options_.doubled).fraction();
  });
}

double SlamEvaluator::success() {
  const double error = largest_error();
  if (error >= options_.success_distance) return 0.0;
  const double excess = excess_doubled_walls();
  if (std::isnan(error) || std::isnan(excess)) return kNone;
  return excess < options_.success_doubled_walls ? 1.0 : 0.0;
}

double SlamEvaluator::has_failed() const {
  if (pairs_.empty()) return kNone;
  return largest_error() > options_.failure_distance ? 1.0 : 0.0;
}

std::vector<std::pair<std::string, double>> SlamEvaluator::values() {
  std::vector<std::pair<std::string, double>> values;
  for (const EvaluatedMetric& row : evaluated_metrics()) {
    if (!input_.wanted.contains(row.metric.name)) continue;
    values.emplace_back(row.metric.name, row.value(*this));
  }
  return values;
}

std::string SlamEvaluator::failure() const {
  if (has_failed() != 1.0) return {};
  return fmt::format("largest position error {:.2f} m", largest_error());
}

std::vector<Metric> slam_metrics() {
  std::vector<Metric> metrics;
  for (const EvaluatedMetric& row : evaluated_metrics()) metrics.push_back(row.metric);
  return metrics;
}

}  // namespace mapbed
