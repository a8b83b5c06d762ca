#include "bench/experiments/false_loops/false_loops.h"

#include <cmath>
#include <memory>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/pose_graph/graph_optimizer.h"
#include "bench/experiments/data_file.h"
#include "bench/experiments/false_loops/added_false_loops.h"
#include "bench/experiments/false_loops/graph_files.h"
#include "bench/process/process_cost.h"

namespace mapbed {
namespace {

enum class GraphOrigin : int { plane, space, file };

struct FalseLoopsExperiment {
  GraphOrigin graph = GraphOrigin::plane;
  std::string file;
  LatticeDriveOptions drive;
  FalseLoopOptions false_loops;
  double allowed_times = 2.0;
  double allowed_more = 0.1;  // [m]
  GraphOptimizationOptions optimization;
};

template <class Visitor>
void visit_fields(FalseLoopsExperiment& o, Visitor&& visit) {
  visit("graph", o.graph, {"plane", "space", "file"},
        "a drive through a city that is another one with each seed, the same in space, or 'file'");
  visit("file", o.file, "of a graph of g2o or TORO, as it is or below MAPBED_DATA");
  visit("drive", o.drive, "drives in plane and space");
  visit("false_loops", o.false_loops, "loop closures that are false");
  visit("allowed_times", o.allowed_times, between(1.0, 1000.0),
        "the error of a success is at most this times that of the optimum without false loop "
        "closures");
  visit("allowed_more", o.allowed_more, Unit::meter, kNotNegative, "and so much more");
  visit("optimization", o.optimization, "how the graph is optimised");
}

// One column each, [m].
template <class Pose>
Eigen::MatrixXd positions_of(const std::vector<Pose>& poses) {
  constexpr int kDimensions = kDegreesOfFreedom<Pose> == 3 ? 2 : 3;
  Eigen::MatrixXd positions(kDimensions, static_cast<Eigen::Index>(poses.size()));
  for (Eigen::Index i = 0; i < positions.cols(); ++i) {
    const Pose& pose = poses[static_cast<std::size_t>(i)];
    if constexpr (kDimensions == 2) {
      positions.col(i) = pose.position();
    } else {
      positions.col(i) = pose.position;
    }
  }
  return positions;
}

// [m] RMS distance from the truth after the best rotation and shift.
template <class Pose>
double error_of(const std::vector<Pose>& poses, const std::vector<Pose>& truth) {
  const Eigen::MatrixXd found = positions_of(poses);
  const Eigen::MatrixXd wanted = positions_of(truth);
  const Eigen::MatrixXd motion = Eigen::umeyama(found, wanted, /*with_scaling=*/false);
  const Eigen::Index dimensions = found.rows();
  const Eigen::MatrixXd aligned = (motion.topLeftCorner(dimensions, dimensions) * found).colwise() +
                                  motion.col(dimensions).head(dimensions);
  return std::sqrt((aligned - wanted).colwise().squaredNorm().mean());
}

// Of some loop closures, how many have a weight on this side of a half.
template <class Pose>
double share_of(const GraphOptimum<Pose>& optimum, const PoseGraph<Pose>& graph, std::size_t begin,
                std::size_t end, bool believed) {
  constexpr double kBelieved = 0.5;
  int all = 0, counted = 0;
  for (std::size_t i = begin; i < end; ++i) {
    if (!graph.constraints[i].closes_loop) continue;
    ++all;
    counted += (optimum.weights[i] >= kBelieved) == believed;
  }
  return all == 0 ? std::nan("") : static_cast<double>(counted) / all;
}

template <class Pose>
RunOutcome run_on(const FalseLoopsExperiment& options, KnownGraph<Pose> known, const Rng& rng) {
  PoseGraph<Pose> right = known.graph;
  right.nodes = known.truth;
  const double clean_error = error_of(optimize(right).poses, known.truth);
  const std::size_t of_right = right.constraints.size();
  add_false_loops(options.false_loops, rng.stream("false loops"), known);

  const double before = processor_time();
  const GraphOptimum<Pose> optimum = optimize(known.graph, options.optimization);
  RunOutcome outcome{.method_seconds = processor_time() - before};
  const std::size_t all = known.graph.constraints.size();
  const double error = error_of(optimum.poses, known.truth);
  const bool success = error <= options.allowed_times * clean_error + options.allowed_more;
  outcome.values = {{"success", success ? 1.0 : 0.0},
                    {"position_error", error},
                    {"clean_error", clean_error},
                    {"right_lost", share_of(optimum, known.graph, 0, of_right, false)},
                    {"iterations", optimum.iterations},
                    {"converged", optimum.converged ? 1.0 : 0.0},
                    {"false_loops", static_cast<double>(all - of_right)}};
  if (all > of_right) {
    outcome.values.emplace_back("false_kept", share_of(optimum, known.graph, of_right, all, true));
  }
  return outcome;
}

RunOutcome run(const FalseLoopsExperiment& options, GraphFiles& files, const std::string& path,
               const Rng& rng) {
  switch (options.graph) {
    case GraphOrigin::plane:
      return run_on(options, lattice_drive<Pose2>(options.drive, rng.stream("drive")), rng);
    case GraphOrigin::space:
      return run_on(options, lattice_drive<Pose3>(options.drive, rng.stream("drive")), rng);
    case GraphOrigin::file:
      break;
  }
  return std::visit([&](const auto& known) { return run_on(options, known, rng); }, files.at(path));
}

Configured<RunOutcome(const RunInput&)> configure(const Settings& settings,
                                                  const std::shared_ptr<GraphFiles>& files) {
  FalseLoopsExperiment options;
  apply(settings, options_of(options), "false_loops");
  const std::string yaml = to_yaml(options_of(options));
  Configured<RunOutcome(const RunInput&)> configured{.complete_yaml = yaml};
  std::string path;
  if (options.graph == GraphOrigin::file) {
    path = place_of_data(options.file);
    if (path.empty()) {
      configured.missing = "the graph " + in_quotes(options.file) + " is not here";
    } else {
      configured.files.push_back(input_file(path));
    }
  }
  configured.make = [options = std::move(options), path, files](const RunInput& input) {
    return run(options, *files, path, input.rng);
  };
  return configured;
}

}  // namespace

Experiment false_loops_experiment() {
  const auto files = std::make_shared<GraphFiles>();
  return {.name = "false_loops",
          .about = "a pose graph some of whose loop closures are false",
          .needs = Experiment::Needs::nothing,
          .metrics = {{"success", Unit::none,
                       "1: the error is at most twice that without false loop closures and 0.1 m "
                       "(allowed_times, allowed_more)",
                       0.0},
                      {"position_error", Unit::meter,
                       "RMS distance of the nodes from the truth after alignment"},
                      {"clean_error", Unit::meter,
                       "the same of the optimum without false loop closures, from the truth on"},
                      {"false_kept", Unit::none,
                       "share of the false loop closures whose weight is at least 0.5 in the end"},
                      {"right_lost", Unit::none,
                       "share of the right loop closures whose weight is below 0.5 in the end"},
                      {"iterations", Unit::none, "systems of equations that were solved"},
                      {"converged", Unit::none, "1: it ended at a minimum", 0.0},
                      {"false_loops", Unit::none, "loop closures that are false"}},
          .configure = [files](const Settings& settings) { return configure(settings, files); }};
}

}  // namespace mapbed
