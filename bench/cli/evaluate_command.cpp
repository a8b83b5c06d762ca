#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/cli/command_line.h"
#include "bench/cli/commands.h"
#include "bench/cli/describe/pose_lines.h"
#include "bench/cli/progress.h"
#include "bench/metrics/evaluation.h"
#include "bench/process/foreign_files.h"
#include "core/file/atomic_file.h"
#include "core/file/text_file.h"
#include "core/geometry/tum_file.h"
#include "core/input_error.h"
#include "core/log/log_file.h"

namespace mapbed {
namespace {

struct EvaluateArguments {
  std::string estimate;
  std::string relations;
  std::string odometry;
  std::string truth;
  std::string json;
  std::string delta_unit = "frames";
  TruthOptions truth_options;
};

Trajectory odometry_from(const std::string& path) {
  if (holds_pose_lines(read_text_file(path))) return load_trajectory(path);
  const Trajectory odometry = odometry_of(load_log(path).measurements);
  if (odometry.empty()) throw InputError({path}, "holds no odometry", "leave --odometry out");
  return odometry;
}

RelationsError against_relations(const Trajectory& estimate, const EvaluateArguments& arguments) {
  const Trajectory odometry =
      arguments.odometry.empty() ? Trajectory{} : odometry_from(arguments.odometry);
  const RelationsError error =
      relations_error(estimate, load_relations(arguments.relations), odometry);
  if (error.count == 0) {
    throw InputError({arguments.relations},
                     fmt::format("all {} relations lie more than 5 s outside the estimate, which "
                                 "goes from {:.6f} to {:.6f} s",
                                 error.skipped, estimate.front().time, estimate.back().time),
                     "are both of the same log?");
  }
  return error;
}

// "nan" and "inf" pass for numbers, but no error can be measured with them.
void check_finite(const EvaluateArguments& arguments) {
  const TruthOptions& options = arguments.truth_options;
  const std::pair<const char*, double> numbers[] = {
      {"--max-time-difference", options.max_time_difference},
      {"--delta", options.relative.delta},
      {"--path-length", options.path_length}};
  for (const auto& [name, value] : numbers) {
    if (!std::isfinite(value))
      throw InputError(fmt::format("{}: {} is no finite number", name, value));
  }
}

Evaluation evaluation_of(const EvaluateArguments& arguments) {
  const Trajectory estimate = load_trajectory(arguments.estimate);
  Evaluation evaluation;
  if (!arguments.relations.empty()) {
    evaluation.relations = against_relations(estimate, arguments);
  }
  if (!arguments.truth.empty()) {
    evaluation.truth =
        compare_with_truth(estimate, load_trajectory(arguments.truth), arguments.truth_options);
  }
  return evaluation;
}

// Nothing is written over but figures of ours.
void refuse_foreign_figures(const std::string& path) {
  if (!std::filesystem::is_regular_file(path) || is_special_file(path)) return;
  const auto json = nlohmann::json::parse(std::ifstream(path), nullptr, false);
  bool is_ours = json.is_object() && !json.empty();
  for (const auto& [key, value] : json.items()) {
    is_ours = is_ours && (key == "relations" || key == "truth") && value.is_object();
  }
  if (!is_ours) refuse_foreign(path);
}

int evaluate(const EvaluateArguments& arguments) {
  if (!arguments.json.empty()) {
    check_writable(arguments.json);
    refuse_foreign_figures(arguments.json);
  }
  const Evaluation evaluation = while_told("evaluating", [&] { return evaluation_of(arguments); });
  if (!arguments.json.empty()) write_file(arguments.json, json_of(evaluation));
  fmt::print("{}", table_of(evaluation));
  return kDone;
}

// Options that can only be judged together.
void check(EvaluateArguments& arguments) {
  if (arguments.relations.empty() && arguments.truth.empty()) {
    throw InputError("evaluate needs something to compare with; give --relations or --truth");
  }
  check_finite(arguments);
  RelativeErrorOptions& relative = arguments.truth_options.relative;
  relative.unit = arguments.delta_unit == "m" ? PathUnit::meters : PathUnit::frames;
  if (relative.unit == PathUnit::frames && relative.delta != std::floor(relative.delta)) {
    throw InputError("--delta counts whole frames; for a length in metres add --delta-unit m");
  }
}

// An option that means something with --truth alone.
CommandOption with_truth(const char* name, OptionTarget target, const char* help,
                         OptionCheck check) {
  const bool is_flag = std::holds_alternative<bool*>(target);
  return {.name = name,
          .target = target,
          .help = help,
          .check = std::move(check),
          .shows_default = !is_flag,
          .needs = "--truth"};
}

}  // namespace

Command evaluate_command() {
  const auto arguments = std::make_shared<EvaluateArguments>();
  EvaluateArguments& a = *arguments;
  TruthOptions& options = a.truth_options;
  return {
      .name = "evaluate",
      .help = "Measure the errors of a trajectory against relations or true poses",
      .options =
          {{.name = "ESTIMATE",
            .target = &a.estimate,
            .help = "the trajectory: lines 't x y z qx qy qz qw' (TUM) or 't x y theta'; this "
                    "and all files may be gzipped",
            .is_required = true},
           {"--relations", &a.relations,
            "relations between stamps, 't1 t2 x y z roll pitch yaw' (Kuemmerle et al. 2009)"},
           {.name = "--odometry",
            .target = &a.odometry,
            .help = "the log, or pose lines: reaches the relations' stamps from the poses beside "
                    "them by odometry instead of linearly",
            .needs = "--relations"},
           {"--truth", &a.truth,
            "true or reference poses, lines as in ESTIMATE; 'mapbed simulate' writes them as "
            "LOG.tum"},
           with_truth("--max-time-difference", &options.max_time_difference,
                      "[s] between an estimated and a true pose of one moment", Sign::not_negative),
           with_truth("--delta", &options.relative.delta,
                      "length of the motions that RPE compares, in --delta-unit", Sign::positive),
           with_truth("--delta-unit", &a.delta_unit, "what --delta counts",
                      std::vector<std::string>{"frames", "m"}),
           with_truth("--all-pairs", &options.relative.all_pairs,
                      "RPE: a motion from every pose on, instead of one behind the other", {}),
           with_truth("--path-length", &options.path_length,
                      "[m] of true path for the error over a length of path", Sign::positive),
           {"-o,--out,--json", &a.json, "write the figures to this file as JSON, with all digits"}},
      .run = [arguments] {
        check(*arguments);
        return evaluate(*arguments);
      }};
}

}  // namespace mapbed
