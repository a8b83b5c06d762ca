#include "bench/experiments/slam_judge.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "bench/metrics/entropy.h"

namespace mapbed {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

struct JudgedMetric {
  Metric metric;
  double (*value)(SlamJudge&);
};

const std::vector<JudgedMetric>& judged_metrics() {
  using J = SlamJudge;
  static const std::vector<JudgedMetric> table{
      {{"translation_error", Unit::meter, "ATE: RMS distance, after the best alignment"},
       [](J& j) { return j.absolute().translation.rmse; }},
      {{"rotation_error", Unit::radian, "ATE: RMS turn, after the best alignment"},
       [](J& j) { return j.absolute().rotation.rmse; }},
      {{"largest_error", Unit::meter, "largest distance, the first poses aligned"},
       [](J& j) { return j.largest_error(); }},
      {{"relative_translation", Unit::meter, "mean error over path_length of true path"},
       [](J& j) { return j.over_path().translation.mean; }},
      {{"relative_rotation", Unit::radian, "the same of the turn"},
       [](J& j) { return j.over_path().rotation.mean; }},
      {{"relations_translation", Unit::meter, "mean error over the measured relations"},
       [](J& j) { return j.relations().mean_translation; }},
      {{"relations_translation_spread", Unit::meter, "standard deviation of these errors"},
       [](J& j) { return j.relations().sigma_translation; }},
      {{"relations_rotation", Unit::radian, "mean error of the turn over the measured relations"},
       [](J& j) { return j.relations().mean_rotation; }},
      {{"relations_rotation_spread", Unit::radian, "standard deviation of these errors"},
       [](J& j) { return j.relations().sigma_rotation; }},
      {{"relations_compared", Unit::none, "relations that the estimate reaches"},
       [](J& j) { return j.relations_compared(); }},
      {{"success", Unit::none,
        "1: largest_error is below success_distance, excess_doubled_walls below "
        "success_doubled_walls",
        0.0},
       [](J& j) { return j.success(); }},
      {{"failures", Unit::none, "1: largest_error is above failure_distance", 1.0},
       [](J& j) { return j.has_failed(); }},
      {{"map_f1", Unit::none, "of occupied cells against the world's own map, see map_error.h"},
       [](J& j) { return j.map_errors().f1(); }},
      {{"map_precision", Unit::none, "share of the occupied cells that are right"},
       [](J& j) { return j.map_errors().precision(); }},
      {{"map_recall", Unit::none, "share of the true occupied cells that were found"},
       [](J& j) { return j.map_errors().recall(); }},
      {{"spurious_cells", Unit::none, "occupied cells without a true one near"},
       [](J& j) { return j.spurious_cells(); }},
      {{"map_coverage", Unit::none, "share of the truly free cells that the map knows"},
       [](J& j) { return j.confusion().coverage(); }},
      {{"free_as_occupied", Unit::none, "share of the truly free cells it knows"},
       [](J& j) { return j.confusion().free_as_occupied(); }},
      {{"occupied_as_free", Unit::none, "share of the truly occupied cells it knows"},
       [](J& j) { return j.confusion().occupied_as_free(); }},
      {{"doubled_walls", Unit::none,
        "share of the true walls with one more near, "
        "see doubled_walls.h"},
       [](J& j) { return j.doubled_walls(); }},
      {{"excess_doubled_walls", Unit::none,
        "doubled_walls less those of the map of the same scans at their true poses"},
       [](J& j) { return j.excess_doubled_walls(); }},
      {{"sharpness", Unit::none,
        "[bit] minus the mean entropy of the known cells; a smeared map knows more of them, so it "
        "compares maps of one size"},
       [](J& j) { return -mean_entropy(j.map()); }},
      {{"untrusted_scans", Unit::none, "scans whose match was not trusted"},
       [](J& j) { return static_cast<double>(j.estimate().untrusted_scans); }},
      {{"path_length", Unit::meter, "of the estimated path"},
       [](J& j) { return path_length(j.estimate().trajectory); }},
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

SlamJudge::SlamJudge(const JudgeOptions& options, const RunInput& input, const Estimate& estimate)
    : options_(options), input_(input), estimate_(estimate) {
  pairs_ = associated(input.truth, estimate.trajectory);
  const Pose2 world_from_map = pairs_.empty() ? Pose2{} : alignment(pairs_);
  world_from_robot_ = transformed(estimate.trajectory, world_from_map);
  absolute_ = absolute_error(pairs_, world_from_map);
  over_path_ = error_over_path(input.truth, estimate.trajectory, options.path_length);
}

const OccupancyMap& SlamJudge::map() {
  return once(map_, [&] { return build_map(input_.log, world_from_robot_, options_.map); });
}

double SlamJudge::largest_error() const {
  if (pairs_.empty()) return kNone;
  double largest = 0.0;
  const Pose2 world_from_map = pairs_.front().truth * inverse(pairs_.front().estimate);
  for (const PosePair& pair : pairs_) {
    largest = std::max(largest, distance(pair.truth, world_from_map * pair.estimate));
  }
  return largest;
}

const RelationsError& SlamJudge::relations() {
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

double SlamJudge::relations_compared() {
  return input_.relations ? relations().count : kNone;
}

const MapErrors& SlamJudge::map_errors() {
  return once(map_errors_,
              [&] { return has_true_map() ? compare_maps(map(), true_map()) : MapErrors{}; });
}

double SlamJudge::spurious_cells() {
  return has_true_map() ? map_errors().spurious() : kNone;
}

const MapConfusion& SlamJudge::confusion() {
  return once(confusion_,
              [&] { return has_true_map() ? confusion_of(map(), true_map()) : MapConfusion{}; });
}

double SlamJudge::doubled_walls() {
  return once(doubled_walls_, [&] {
    if (!has_true_map()) return kNone;
    return mapbed::doubled_walls(map(), true_map(), options_.doubled).share();
  });
}

double SlamJudge::excess_doubled_walls() {
  return once(excess_doubled_walls_, [&] {
    if (!has_true_map()) return kNone;
    const Trajectory truth = truth_at_stamps(input_.truth, estimate_.trajectory);
    if (truth.empty()) return kNone;
    const OccupancyMap ideal = build_map(input_.log, truth, options_.map);
    return doubled_walls() - mapbed::doubled_walls(ideal, true_map(), options_.doubled).share();
  });
}

double SlamJudge::success() {
  const double error = largest_error();
  if (error >= options_.success_distance) return 0.0;
  const double excess = excess_doubled_walls();
  if (std::isnan(error) || std::isnan(excess)) return kNone;
  return excess < options_.success_doubled_walls ? 1.0 : 0.0;
}

double SlamJudge::has_failed() const {
  if (pairs_.empty()) return kNone;
  return largest_error() > options_.failure_distance ? 1.0 : 0.0;
}

std::vector<std::pair<std::string, double>> SlamJudge::values() {
  std::vector<std::pair<std::string, double>> values;
  for (const JudgedMetric& row : judged_metrics()) {
    if (!input_.wanted.contains(row.metric.name)) continue;
    values.emplace_back(row.metric.name, row.value(*this));
  }
  return values;
}

std::string SlamJudge::failure() const {
  if (has_failed() != 1.0) return {};
  return fmt::format("largest position error {:.2f} m", largest_error());
}

std::vector<Metric> slam_metrics() {
  std::vector<Metric> metrics;
  for (const JudgedMetric& row : judged_metrics()) metrics.push_back(row.metric);
  return metrics;
}

}  // namespace mapbed
