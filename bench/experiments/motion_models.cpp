#include "bench/experiments/motion_models.h"

#include <algorithm>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "algorithms/input/input_stage.h"
#include "algorithms/motion/motion_learning.h"
#include "algorithms/rbpf/grid_slam.h"
#include "bench/experiments/motion_clouds.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr std::size_t kLeastMotions = 40;  // a model of eight parameters needs more

struct MotionModelsExperiment {
  int moves = 10;
  int cloud = 1000;
  std::string odometry_file;
  std::string matching_file;
  double longest = 0.0;  // [s]
  InputOptions input;
  // Its motions alone count, not where they lead to.
  GridSlamOptions filter{
      .particles = 1, .proposal = Proposal::scan_matching, .relocalization = {.max_updates = 0}};
  GridSlamOptions reference{.refinement = {.enabled = true}};
};

template <class Visitor>
void visit_fields(MotionModelsExperiment& o, Visitor&& visit) {
  visit("moves", o.moves, between(1, 100'000), "after which the clouds are compared");
  visit("cloud", o.cloud, between(10, 1'000'000), "samples of a cloud");
  visit("odometry_file", o.odometry_file, "parameters of raw odometry that are checked as well");
  visit("matching_file", o.matching_file, "parameters of scan matching that are checked as well");
  visit("longest", o.longest, Unit::second, kNotNegative,
        "of the log, what comes later is left out; 0: all of it counts");
  visit("input", o.input, "how what sensors tell is prepared for the filters");
  visit("filter", o.filter, "how scans are matched and condensed; the particle filter's options");
  visit("reference", o.reference,
        "the particle filter whose path stands for the true one where nobody knows that");
}

// The options, and the models of the parameter files that they name.
struct Setup {
  MotionModelsExperiment options;
  std::optional<MotionModelOptions> odometry;
  std::optional<MotionModelOptions> matching;
};

std::optional<MotionModelOptions> model_of(const std::string& file) {
  return file.empty() ? std::nullopt : std::optional(load_motion_model(file));
}

// The true path; of a recorded log what the particle filter makes of it, as in section 5.3.
Trajectory reference_of(const MotionModelsExperiment& options, const RunInput& input) {
  if (!input.truth.empty()) return input.truth;
  GridSlam filter(options.reference, input.rng.stream("reference"));
  for (const Measurement& measurement : input.log) filter.add(measurement);
  return filter.estimate().trajectory;
}

// The same motions, seen by odometry and by scan matching.
struct Motions {
  std::vector<MotionSample> odometry;
  std::vector<MotionSample> matching;
};

Motions motions_of(const MotionModelsExperiment& options, const RunInput& input) {
  GridSlam filter(options.filter, input.rng.stream("filter"));
  for (const Measurement& measurement : input.log) filter.add(measurement);
  const Trajectory odometry = odometry_of(input.log);
  const Trajectory references = reference_of(options, input);
  const auto between = [](const Trajectory& path, const GridSlam::Motion& step) {
    const auto from = pose_at(path, step.from_time), to = pose_at(path, step.to_time);
    return from && to ? std::optional<Pose2>(motion_between(*from, *to)) : std::optional<Pose2>{};
  };
  Motions result;
  for (const GridSlam::Motion& step : filter.motions()) {
    const auto reference = between(references, step);
    const auto by_odometry = between(odometry, step);
    if (!reference || !by_odometry) continue;
    result.odometry.push_back({*by_odometry, *reference});
    result.matching.push_back({step.motion, *reference});
  }
  if (result.odometry.size() <
      std::max(kLeastMotions, 2 * static_cast<std::size_t>(options.moves))) {
    throw InputError({},
                     fmt::format("the log has {} motions with true poses, too few to learn from",
                                 result.odometry.size()),
                     "take a longer one");
  }
  return result;
}

std::vector<MotionSample> part_of(const std::vector<MotionSample>& samples, bool first_half) {
  const auto middle = samples.begin() + static_cast<std::ptrdiff_t>(samples.size() / 2);
  return first_half ? std::vector<MotionSample>(samples.begin(), middle)
                    : std::vector<MotionSample>(middle, samples.end());
}

void report_model(const std::string& name, const MotionModelOptions& m, RunOutcome& outcome) {
  for (const auto& [parameter, value] : std::vector<std::pair<std::string, double>>{
           {"rotation_per_rotation", m.rotation_per_rotation},
           {"rotation_per_meter", m.rotation_per_meter},
           {"translation_per_meter", m.translation_per_meter},
           {"translation_per_rotation", m.translation_per_rotation},
           {"least_rotation_sigma", m.least_rotation_sigma},
           {"least_translation_sigma", m.least_translation_sigma},
           {"rotation_bias", m.rotation_bias},
           {"translation_bias", m.translation_bias}}) {
    outcome.values.emplace_back(name + "_" + parameter, value);
  }
}

void report_calibration(const std::string& name, const std::vector<MotionSample>& held_out,
                        const MotionModelOptions& model, RunOutcome& outcome) {
  const Calibration calibration = calibration_of(held_out, model);
  outcome.values.emplace_back(name + "_nees", calibration.nees);
  outcome.values.emplace_back(name + "_coverage", calibration.coverage);
  outcome.values.emplace_back(name + "_autocorrelation", autocorrelation_of(held_out, model));
}

// Learns, and checks on the held-out half; the model of the parameter file as well.
MotionModelOptions learned_and_checked(const std::string& name,
                                       const std::vector<MotionSample>& samples,
                                       const std::optional<MotionModelOptions>& of_file,
                                       const RunInput& input, RunOutcome& outcome) {
  const std::vector<MotionSample> held_out = part_of(samples, false);
  MotionModelOptions learned = learned_motion_model(part_of(samples, true));
  report_model(name, learned, outcome);
  report_calibration(name, held_out, learned, outcome);
  if (of_file) report_calibration(name + "_file", held_out, *of_file, outcome);
  if (input.shown) {
    outcome.files.push_back({"learned/" + name + ".yaml", to_yaml(options_of(learned))});
  }
  return learned;
}

// MotionClouds of the same moves by both models.
struct Comparison {
  std::size_t first = 0;  // of the moves, in the held-out half
  MotionClouds odometry, matching;

  double odometry_area() const { return ellipse_of(odometry.back()).area(); }
  double matching_area() const { return ellipse_of(matching.back()).area(); }
  double ratio() const { return odometry_area() / matching_area(); }
};

// One after the other through the held-out half; the one of the median ratio.
Comparison compared(const Motions& held_out, const MotionModelOptions& odometry,
                    const MotionModelOptions& matching, const MotionModelsExperiment& options,
                    const Rng& rng) {
  const auto length = static_cast<std::size_t>(options.moves);
  std::vector<Comparison> all;
  for (std::size_t first = 0; first + length <= held_out.odometry.size(); first += length) {
    const auto moves = [&](const std::vector<MotionSample>& samples) {
      return std::span<const MotionSample>(samples).subspan(first, length);
    };
    all.push_back({first,
                   clouds_of(moves(held_out.odometry), odometry, options.cloud,
                             rng.stream("odometry cloud", first)),
                   clouds_of(moves(held_out.matching), matching, options.cloud,
                             rng.stream("matching cloud", first))});
  }
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end(),
                   [](const Comparison& a, const Comparison& b) { return a.ratio() < b.ratio(); });
  return std::move(*middle);
}

RunOutcome run(const Setup& setup, const RunInput& whole_input) {
  const MotionModelsExperiment& options = setup.options;
  RunInput input = shortened(whole_input, options.longest);
  input.log = prepared(std::move(input.log), options.input).log;
  const Motions motions = motions_of(options, input);
  RunOutcome outcome;
  outcome.values.emplace_back("motions", static_cast<double>(motions.odometry.size()));
  const MotionModelOptions odometry =
      learned_and_checked("odometry", motions.odometry, setup.odometry, input, outcome);
  const MotionModelOptions matching =
      learned_and_checked("matching", motions.matching, setup.matching, input, outcome);
  const Motions held_out{part_of(motions.odometry, false), part_of(motions.matching, false)};
  const Comparison typical = compared(held_out, odometry, matching, options, input.rng);
  outcome.values.emplace_back("odometry_cloud_area", typical.odometry_area());
  outcome.values.emplace_back("matching_cloud_area", typical.matching_area());
  outcome.values.emplace_back("cloud_ratio", typical.ratio());
  if (!input.shown) return outcome;
  const auto moves = std::span<const MotionSample>(held_out.odometry)
                         .subspan(typical.first, static_cast<std::size_t>(options.moves));
  for (ResultFile& file : clouds_figure(moves, typical.odometry, typical.matching, input.label)) {
    outcome.files.push_back(std::move(file));
  }
  return outcome;
}

Configured<RunOutcome(const RunInput&)> configure(const Settings& settings) {
  Setup setup;
  apply(settings, options_of(setup.options), "motion_models");
  InputFiles files;
  for (const std::string& file : {setup.options.odometry_file, setup.options.matching_file}) {
    if (!file.empty()) merge({motion_model_file(file)}, files);
  }
  setup.odometry = model_of(setup.options.odometry_file);
  setup.matching = model_of(setup.options.matching_file);
  const std::string yaml = to_yaml(options_of(setup.options));
  return {yaml, [setup = std::move(setup)](const RunInput& input) { return run(setup, input); },
          std::move(files)};
}

// Of odometry and of scan matching alike.
void add_metrics(const std::string& name, const std::string& what, std::vector<Metric>& metrics) {
  const auto add = [&](const std::string& suffix, Unit unit, const std::string& about) {
    metrics.push_back({name + "_" + suffix, unit, about + ", " + what});
  };
  add("cloud_area", Unit::none, "[m^2] of the 95 % ellipse of x and y after the last move");
  add("nees", Unit::none,
      "mean normalised error squared (NEES) of held-out motions by their degrees of freedom");
  add("coverage", Unit::none, "fraction of held-out motions within the model's 95 % ellipsoid");
  add("autocorrelation", Unit::none, "of the errors of successive held-out motions");
  add("file_autocorrelation", Unit::none, "the same by the parameter file");
  add("file_nees", Unit::none, "the NEES by the parameter file");
  add("file_coverage", Unit::none, "the coverage by the parameter file");
  add("rotation_per_rotation", Unit::radian, "learned sigma of a rotation after 1 rad");
  add("rotation_per_meter", Unit::radian, "learned sigma of a rotation after 1 m");
  add("translation_per_meter", Unit::meter, "learned sigma of the translation after 1 m");
  add("translation_per_rotation", Unit::meter, "learned sigma of the translation after 1 rad");
  add("least_rotation_sigma", Unit::radian, "learned least sigma of a rotation");
  add("least_translation_sigma", Unit::meter, "learned least sigma of the translation");
  add("rotation_bias", Unit::none, "learned mean error of rotations, as a fraction");
  add("translation_bias", Unit::none, "learned mean error of translations, as a fraction");
}

}  // namespace

Experiment motion_models_experiment() {
  std::vector<Metric> metrics{
      {"motions", Unit::none, "from update to update, of which a half was learned from"},
      {"cloud_ratio", Unit::none,
       "area of odometry's cloud by that of scan matching's, median over the held-out half"}};
  add_metrics("odometry", "raw odometry", metrics);
  add_metrics("matching", "scan matching", metrics);
  return {.name = "motion_models",
          .about = "error models of odometry and scan matching are learned, section 5.3",
          .needs = Experiment::Needs::log,
          .metrics = std::move(metrics),
          .configure = configure};
}

}  // namespace mapbed
