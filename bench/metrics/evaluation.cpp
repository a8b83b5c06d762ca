#include "bench/metrics/evaluation.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/config/quantity.h"
#include "core/geometry/angle.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

using Json = nlohmann::ordered_json;

Trajectory sorted_by_time(Trajectory trajectory) {
  std::stable_sort(
      trajectory.begin(), trajectory.end(),
      [](const Stamped<Pose2>& a, const Stamped<Pose2>& b) { return a.time < b.time; });
  return trajectory;
}

// How many have one of the others within that time [s].
int count_with_partner(const Trajectory& poses, const Trajectory& others, double difference) {
  const auto has_partner = [&](const Stamped<Pose2>& pose) {
    const auto later = std::lower_bound(
        others.begin(), others.end(), pose.time,
        [](const Stamped<Pose2>& other, double time) { return other.time < time; });
    return (later != others.end() && later->time - pose.time <= difference) ||
           (later != others.begin() && pose.time - (later - 1)->time <= difference);
  };
  return static_cast<int>(std::count_if(poses.begin(), poses.end(), has_partner));
}

int count_outside(const Trajectory& poses, const Trajectory& others, double difference) {
  const auto is_outside = [&](const Stamped<Pose2>& pose) {
    return others.front().time - pose.time > difference ||
           pose.time - others.back().time > difference;
  };
  return static_cast<int>(std::count_if(poses.begin(), poses.end(), is_outside));
}

std::string name_of(const RelativeErrorOptions& options) {
  return fmt::format("RPE, every {:g} {}{}", options.delta,
                     options.unit == PathUnit::frames ? "frames" : "m",
                     options.all_pairs ? ", all pairs" : "");
}

std::string row_of(const char* name, Unit unit, const ErrorStatistics& s) {
  if (s.count == 0) return fmt::format("  {:<18} nothing to compare\n", name);
  const std::string symbol = "[" + display_symbol(unit) + "]";
  const auto shown = [unit](double value) { return displayed(value, unit); };
  return fmt::format("  {:<12} {:<5} {:>10.6f} {:>10.6f} {:>10.6f} {:>10.6f} {:>10.6f} {:>10.6f}\n",
                     name, symbol, shown(s.rmse), shown(s.mean), shown(s.median), shown(s.sigma),
                     shown(s.min), shown(s.max));
}

std::string rows_of(const std::string& title, const PoseErrors& errors) {
  return fmt::format("{}: {} {}\n", title, errors.translation.count,
                     errors.translation.count == 1 ? "comparison" : "comparisons") +
         row_of("translation", Unit::meter, errors.translation) +
         row_of("rotation", Unit::radian, errors.rotation);
}

std::string row_of(const char* name, Unit unit, double mean, double sigma) {
  return fmt::format("  {:<12} mean {:.6f} {}, std {:.6f} {}\n", name, displayed(mean, unit),
                     display_symbol(unit), displayed(sigma, unit), display_symbol(unit));
}

std::string rows_of(const RelationsError& error) {
  return fmt::format(
             "relations: {} compared, {} skipped (a stamp more than 5 s outside the estimate)\n",
             error.count, error.skipped) +
         row_of("translation", Unit::meter, error.mean_translation, error.sigma_translation) +
         row_of("rotation", Unit::radian, error.mean_rotation, error.sigma_rotation);
}

// Of what is not compared, why.
std::string row_of_estimated(const TruthErrors& errors) {
  const int left = errors.estimated_poses - errors.estimated_with_truth;
  const int between = left - errors.estimated_outside;
  std::string text = fmt::format("estimate: {} of {} poses have a true one",
                                 errors.estimated_with_truth, errors.estimated_poses);
  if (left == 0) return text + "\n";
  text += fmt::format("; {} {} not compared:", left, left == 1 ? "is" : "are");
  if (errors.estimated_outside > 0)
    text += fmt::format(" {} before or after all truth", errors.estimated_outside);
  if (errors.estimated_outside > 0 && between > 0) text += ",";
  if (between > 0) text += fmt::format(" {} between true poses", between);
  return text + "\n";
}

std::string rows_of(const TruthErrors& errors) {
  return fmt::format("truth: {} of {} true poses have an estimate within {:g} s\n",
                     errors.true_with_estimate, errors.true_poses,
                     errors.options.max_time_difference) +
         row_of_estimated(errors) +
         fmt::format("  {:<18} {:>10} {:>10} {:>10} {:>10} {:>10} {:>10}\n", "", "rmse", "mean",
                     "median", "std", "min", "max") +
         rows_of("ATE, after alignment", errors.absolute) +
         rows_of(name_of(errors.options.relative), errors.relative) +
         rows_of(fmt::format("error over {:g} m of path", errors.options.path_length),
                 errors.over_path);
}

// JSON has no NaN: null.
Json json_of(const ErrorStatistics& s) {
  return {{"count", s.count}, {"rmse", s.rmse}, {"mean", s.mean}, {"median", s.median},
          {"std", s.sigma},   {"min", s.min},   {"max", s.max}};
}

Json json_of(const PoseErrors& errors) {
  return {{"translation_m", json_of(errors.translation)},
          {"rotation_rad", json_of(errors.rotation)}};
}

Json json_of(const RelationsError& error) {
  return {{"count", error.count},
          {"skipped", error.skipped},
          {"mean_translation_m", error.mean_translation},
          {"std_translation_m", error.sigma_translation},
          {"mean_rotation_rad", error.mean_rotation},
          {"std_rotation_rad", error.sigma_rotation},
          {"mean_rotation_deg", degrees(error.mean_rotation)},
          {"std_rotation_deg", degrees(error.sigma_rotation)}};
}

Json json_of(const TruthErrors& errors) {
  const TruthOptions& options = errors.options;
  const Pose2& alignment = errors.world_from_map;
  return {
      {"true_poses", errors.true_poses},
      {"true_poses_with_estimate", errors.true_with_estimate},
      {"estimated_poses", errors.estimated_poses},
      {"estimated_poses_with_truth", errors.estimated_with_truth},
      {"estimated_poses_outside_truth", errors.estimated_outside},
      {"pairs", errors.pairs},
      {"max_time_difference_s", options.max_time_difference},
      {"world_from_map", {alignment.x, alignment.y, alignment.theta}},
      {"absolute", json_of(errors.absolute)},
      {"relative",
       {{"delta", options.relative.delta},
        {"unit", options.relative.unit == PathUnit::frames ? "frames" : "m"},
        {"all_pairs", options.relative.all_pairs},
        {"errors", json_of(errors.relative)}}},
      {"over_path", {{"length_m", options.path_length}, {"errors", json_of(errors.over_path)}}}};
}

}  // namespace

TruthErrors compare_with_truth(Trajectory estimate, Trajectory truth, const TruthOptions& options) {
  estimate = sorted_by_time(std::move(estimate));
  truth = sorted_by_time(std::move(truth));
  const std::vector<PosePair> pairs = associated(truth, estimate, options.max_time_difference);
  if (pairs.empty()) {
    throw InputError(fmt::format(
        "no true pose lies within {:g} s of an estimated one (estimate: {:.6f} to {:.6f} s, "
        "truth: {:.6f} to {:.6f} s); are both of the same log? --max-time-difference allows more",
        options.max_time_difference, estimate.empty() ? 0.0 : estimate.front().time,
        estimate.empty() ? 0.0 : estimate.back().time, truth.empty() ? 0.0 : truth.front().time,
        truth.empty() ? 0.0 : truth.back().time));
  }
  const double within = options.max_time_difference;
  TruthErrors errors{.options = options,
                     .true_poses = static_cast<int>(truth.size()),
                     .true_with_estimate = count_with_partner(truth, estimate, within),
                     .estimated_poses = static_cast<int>(estimate.size()),
                     .estimated_with_truth = count_with_partner(estimate, truth, within),
                     .estimated_outside = count_outside(estimate, truth, within),
                     .pairs = static_cast<int>(pairs.size()),
                     .world_from_map = alignment(pairs)};
  errors.absolute = absolute_error(pairs, errors.world_from_map);
  errors.relative = relative_error(pairs, options.relative);
  errors.over_path = error_over_path(truth, estimate, options.path_length);
  return errors;
}

std::string table_of(const Evaluation& evaluation) {
  std::string text;
  if (evaluation.relations) text += rows_of(*evaluation.relations);
  if (evaluation.truth) text += rows_of(*evaluation.truth);
  return text;
}

std::string json_of(const Evaluation& evaluation) {
  Json json = Json::object();
  if (evaluation.relations) json["relations"] = json_of(*evaluation.relations);
  if (evaluation.truth) json["truth"] = json_of(*evaluation.truth);
  return json.dump(2) + "\n";
}

}  // namespace mapbed
