#include "bench/experiments/motion_models.h"

#include <cmath>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "algorithms/rbpf/grid_slam.h"
#include "algorithms/rbpf/motion_learning.h"
#include "bench/report/plot.h"
#include "core/geometry/angle.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr std::size_t kLeastMotions = 40;  // a model of eight parameters needs more

struct MotionModelsExperiment {
  int moves = 10;
  int cloud = 2000;
  std::string odometry_file;
  std::string matching_file;
  GridSlamOptions filter{.particles = 1, .proposal = Proposal::scan_matching};
};

template <class Visitor>
void visit_fields(MotionModelsExperiment& o, Visitor&& visit) {
  visit("moves", o.moves, at_least(1), "after which the clouds are compared");
  visit("cloud", o.cloud, at_least(10), "samples of a cloud");
  visit("odometry_file", o.odometry_file, "parameters of raw odometry that are checked as well");
  visit("matching_file", o.matching_file, "parameters of scan matching that are checked as well");
  visit("filter", o.filter, "how scans are matched and condensed; the particle filter's options");
}

// The same motions, seen by odometry and by scan matching.
struct Motions {
  std::vector<MotionSample> odometry;
  std::vector<MotionSample> matching;
};

Motions motions_of(const MotionModelsExperiment& options, const RunInput& input) {
  GridSlam filter(options.filter, input.rng.stream("filter"));
  Trajectory odometry;
  for (const Measurement& measurement : input.log) {
    filter.add(measurement);
    if (const auto* reading = std::get_if<Odometry>(&measurement)) {
      odometry.push_back({reading->time, reading->odometry_from_robot});
    }
  }
  const auto between = [](const Trajectory& path, const GridSlam::Motion& step) {
    const auto from = pose_at(path, step.from_time), to = pose_at(path, step.to_time);
    return from && to ? std::optional<Pose2>(motion_between(*from, *to)) : std::optional<Pose2>{};
  };
  Motions result;
  for (const GridSlam::Motion& step : filter.motions()) {
    const auto reference = between(input.truth, step);
    const auto by_odometry = between(odometry, step);
    // Only motions that do not know the scan at their end, as the particles get them.
    if (!step.condensed || !reference || !by_odometry) continue;
    result.odometry.push_back({*by_odometry, *reference});
    result.matching.push_back({step.motion, *reference});
  }
  if (result.odometry.size() <
      std::max(kLeastMotions, 2 * static_cast<std::size_t>(options.moves))) {
    throw InputError({},
                     fmt::format("the log has {} motions with true poses, too few to learn from",
                                 result.odometry.size()),
                     "take a longer one, simulated");
  }
  return result;
}

std::vector<MotionSample> part_of(const std::vector<MotionSample>& samples, bool first_half) {
  const auto middle = samples.begin() + static_cast<std::ptrdiff_t>(samples.size() / 2);
  return first_half ? std::vector<MotionSample>(samples.begin(), middle)
                    : std::vector<MotionSample>(middle, samples.end());
}

// Where the robot may be after each of the first moves of the held-out half.
using Clouds = std::vector<std::vector<Pose2>>;

Clouds clouds_of(const std::vector<MotionSample>& held_out, const MotionModelOptions& model,
                 const MotionModelsExperiment& options, Rng rng) {
  Clouds clouds;
  std::vector<Pose2> cloud(static_cast<std::size_t>(options.cloud));
  for (int move = 0; move < options.moves; ++move) {
    const Pose2& measured = held_out[static_cast<std::size_t>(move)].measured;
    for (Pose2& pose : cloud) pose = pose * sampled_motion(measured, model, rng);
    clouds.push_back(cloud);
  }
  return clouds;
}

struct Ellipse {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  Eigen::Matrix2d root = Eigen::Matrix2d::Zero();  // of the covariance
  static constexpr double kRadius = 2.447746831;   // 95 %: sqrt of chi-squared with 2 freedoms

  double area() const { return kPi * kRadius * kRadius * std::abs(root.determinant()); }  // [m^2]
};

Ellipse ellipse_of(const std::vector<Pose2>& cloud) {
  Ellipse ellipse;
  const auto n = static_cast<double>(cloud.size());
  for (const Pose2& pose : cloud) ellipse.center += pose.position() / n;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  for (const Pose2& pose : cloud) {
    const Eigen::Vector2d off = pose.position() - ellipse.center;
    covariance += off * off.transpose() / n;
  }
  ellipse.root = covariance.llt().matrixL();
  return ellipse;
}

Series dots_of(const std::string& name, const Clouds& clouds) {
  constexpr std::size_t kDrawn = 150;  // of each cloud
  Series series{.name = name, .mark = Mark::dots};
  for (const std::vector<Pose2>& cloud : clouds) {
    for (std::size_t i = 0; i < std::min(kDrawn, cloud.size()); ++i) {
      series.x.push_back(cloud[i].x);
      series.y.push_back(cloud[i].y);
    }
  }
  return series;
}

Series outline_of(const std::string& name, const Ellipse& ellipse, int like) {
  Series series{.name = name, .mark = Mark::path, .like = like};
  for (int i = 0; i <= 72; ++i) {
    const double angle = radians(5.0 * i);
    const Eigen::Vector2d point =
        ellipse.center +
        Ellipse::kRadius * ellipse.root * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    series.x.push_back(point.x());
    series.y.push_back(point.y());
  }
  return series;
}

Series true_path(const std::vector<MotionSample>& held_out, int moves) {
  Series series{.name = "true path", .x = {0.0}, .y = {0.0}};
  Pose2 pose;
  for (int move = 0; move < moves; ++move) {
    pose = pose * held_out[static_cast<std::size_t>(move)].reference;
    series.x.push_back(pose.x);
    series.y.push_back(pose.y);
  }
  return series;
}

std::vector<ResultFile> figure_of(const MotionModelsExperiment& options,
                                  const std::vector<MotionSample>& held_out, const Clouds& odometry,
                                  const Clouds& matching) {
  Plot plot{.title = fmt::format("Where the robot may be after each of {} moves", options.moves),
            .subtitle =
                "150 samples of each, by the models learned from the other half of the "
                "drive; ellipses: 95 % after the last move; beside Figure 5.3",
            .x = {"x, the robot looks along it at the start", "m"},
            .y = {"y", "m"},
            .equal_scales = true};
  plot.series = {dots_of("raw odometry", odometry), dots_of("scan matching", matching),
                 outline_of("", ellipse_of(odometry.back()), 0),
                 outline_of("", ellipse_of(matching.back()), 1),
                 true_path(held_out, options.moves)};
  return {{"figures/clouds.svg", svg_of(plot)}, {"figures/clouds.csv", csv_of(plot)}};
}

void report_model(const std::string& name, const MotionModelOptions& m, RunOutcome& outcome) {
  for (const auto& [parameter, value] :
       std::vector<std::pair<std::string, double>>{{"turn_noise", m.turn_noise},
                                                   {"turn_per_meter", m.turn_per_meter},
                                                   {"way_per_meter", m.way_per_meter},
                                                   {"way_per_turn", m.way_per_turn},
                                                   {"floor_turn", m.floor_turn},
                                                   {"floor_way", m.floor_way},
                                                   {"turn_bias", m.turn_bias},
                                                   {"way_bias", m.way_bias}}) {
    outcome.values.emplace_back(name + "_" + parameter, value);
  }
}

void report_calibration(const std::string& name, const std::vector<MotionSample>& held_out,
                        const MotionModelOptions& model, RunOutcome& outcome) {
  const Calibration calibration = calibration_of(held_out, model);
  outcome.values.emplace_back(name + "_normalized_error", calibration.normalized_error);
  outcome.values.emplace_back(name + "_inside", calibration.inside);
}

// Learns, checks on the held-out half, and gives the clouds.
Clouds judge(const std::string& name, const std::vector<MotionSample>& samples,
             const std::string& file, const MotionModelsExperiment& options, const RunInput& input,
             RunOutcome& outcome) {
  const std::vector<MotionSample> held_out = part_of(samples, false);
  MotionModelOptions learned = learned_motion_model(part_of(samples, true));
  report_model(name, learned, outcome);
  report_calibration(name, held_out, learned, outcome);
  if (!file.empty()) report_calibration(name + "_file", held_out, load_motion_model(file), outcome);
  if (input.shown) {
    outcome.files.push_back({"learned/" + name + ".yaml", to_yaml(options_of(learned))});
  }
  const Clouds clouds = clouds_of(held_out, learned, options, input.rng.stream(name));
  outcome.values.emplace_back(name + "_cloud_area", ellipse_of(clouds.back()).area());
  return clouds;
}

RunOutcome run(const MotionModelsExperiment& options, const RunInput& input) {
  const Motions motions = motions_of(options, input);
  RunOutcome outcome;
  outcome.values.emplace_back("motions", static_cast<double>(motions.odometry.size()));
  const Clouds odometry =
      judge("odometry", motions.odometry, options.odometry_file, options, input, outcome);
  const Clouds matching =
      judge("matching", motions.matching, options.matching_file, options, input, outcome);
  outcome.values.emplace_back(
      "cloud_ratio", ellipse_of(odometry.back()).area() / ellipse_of(matching.back()).area());
  if (input.shown) {
    for (ResultFile& file :
         figure_of(options, part_of(motions.odometry, false), odometry, matching)) {
      outcome.files.push_back(std::move(file));
    }
  }
  return outcome;
}

// Of odometry and of scan matching alike.
void add_metrics(const std::string& name, const std::string& what, std::vector<Metric>& metrics) {
  const auto add = [&](const std::string& suffix, Unit unit, const std::string& about) {
    metrics.push_back({name + "_" + suffix, unit, about + ", " + what});
  };
  add("cloud_area", Unit::none, "[m^2] of the 95 % ellipse of x and y after the last move");
  add("normalized_error", Unit::none, "mean squared error on held-out motions by the model's own");
  add("inside", Unit::none, "share of held-out motions within the model's 95 % ellipsoid");
  add("file_normalized_error", Unit::none, "the mean squared error, by the parameter file");
  add("file_inside", Unit::none, "the share inside, by the parameter file");
  add("turn_noise", Unit::radian, "learned spread of a turn after 1 rad");
  add("turn_per_meter", Unit::radian, "learned spread of a turn after 1 m");
  add("way_per_meter", Unit::meter, "learned spread of the way after 1 m");
  add("way_per_turn", Unit::meter, "learned spread of the way after 1 rad");
  add("floor_turn", Unit::radian, "learned least spread of a turn");
  add("floor_way", Unit::meter, "learned least spread of the way");
  add("turn_bias", Unit::none, "learned mean error of turns, as a share");
  add("way_bias", Unit::none, "learned mean error of ways, as a share");
}

}  // namespace

Experiment motion_models_experiment() {
  std::vector<Metric> metrics{
      {"motions", Unit::none, "from update to update, of which a half was learned from"},
      {"cloud_ratio", Unit::none, "area of odometry's cloud by that of scan matching's"}};
  add_metrics("odometry", "raw odometry", metrics);
  add_metrics("matching", "scan matching", metrics);
  return make_experiment<MotionModelsExperiment>(
      "motion_models", "error models of odometry and scan matching are learned, section 5.3", true,
      std::move(metrics), run);
}

}  // namespace mapbed
