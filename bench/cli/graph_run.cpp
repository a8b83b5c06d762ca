#include "bench/cli/graph_run.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "algorithms/pose_graph/constraint_error.h"
#include "algorithms/pose_graph/initial_poses.h"
#include "bench/plot/graph_picture.h"
#include "bench/process/foreign_files.h"
#include "bench/process/stopwatch.h"
#include "core/file/atomic_file.h"
#include "core/file/utf8.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

constexpr const char* kReport = "graph.json";

template <class Pose>
double chi2_of(const PoseGraph<Pose>& graph) {
  double sum = 0.0;
  for (const auto& constraint : graph.constraints) sum += chi_square_of(constraint, graph.nodes);
  return sum;
}

struct NamedStart {
  const char* name;
  double chi2 = 0.0;
};

// Moves the nodes to where it is to begin.
template <class Pose>
NamedStart choose_start(const std::string& path, const GraphRun& run, PoseGraph<Pose>& graph) {
  const GraphStart start = run.config.start;
  if (start == GraphStart::file && !run.file.has_poses) {
    throw InputError({path}, "has edges alone, and no poses to begin with",
                     "leave 'start' out, or take chordal or spanning_tree");
  }
  if (start == GraphStart::file) return {"the file's poses", run.file_chi2};
  PoseGraph<Pose> other = graph;
  other.nodes =
      start == GraphStart::spanning_tree ? spanning_tree_poses(graph) : chordal_poses(graph);
  const double chi2 = chi2_of(other);
  if (start == GraphStart::best && run.file.has_poses && run.file_chi2 <= chi2) {
    return {"the file's poses", run.file_chi2};
  }
  graph = std::move(other);
  return {start == GraphStart::spanning_tree ? "a spanning tree" : "chordal poses", chi2};
}

template <class Pose>
void optimize_graph(const std::string& path, PoseGraph<Pose> graph, GraphRun& run) {
  const Stopwatch stopwatch;
  if (run.file.has_poses) run.file_chi2 = chi2_of(graph);
  const NamedStart start = choose_start(path, run, graph);
  run.start_name = start.name;
  run.start_chi2 = start.chi2;
  run.start = graph;
  GraphOptimum<Pose> optimum = optimize(graph, run.config.optimization);
  run.seconds = stopwatch.seconds();

  for (const auto& constraint : graph.constraints) run.loop_closures += constraint.closes_loop;
  const std::vector<int> components = components_of(graph);
  run.components =
      components.empty() ? 0 : 1 + *std::max_element(components.begin(), components.end());
  graph.nodes = std::move(optimum.poses);
  // Two nodes of a component that are held say more than its constraints.
  const bool is_free = static_cast<int>(graph.held.size()) <= run.components;
  if (run.config.certify && run.config.optimization.robust.loss == RobustLoss::none && is_free &&
      !graph.constraints.empty()) {
    const Stopwatch certifying;
    run.certificate = certify(graph);
    run.certificate_seconds = certifying.seconds();
  }
  run.best = std::move(graph);
  run.chi2 = optimum.chi2_after;
  run.iterations = optimum.iterations;
  run.converged = optimum.converged;
  run.weights = std::move(optimum.weights);
}

nlohmann::ordered_json certificate_json(const Certificate& certificate) {
  nlohmann::ordered_json json;
  json["certified"] = certificate.certified;
  json["problem"] = certificate.problem == CertifiedProblem::own ? "own" : "isotropic";
  json["anisotropy"] = certificate.anisotropy;
  json["stationary"] = certificate.stationary;
  json["objective"] = certificate.objective;
  json["lower_bound"] = certificate.lower_bound;
  json["gap"] = certificate.gap;
  json["min_eigenvalue"] = certificate.min_eigenvalue;
  json["moved"] = certificate.moved;
  json["turned"] = certificate.turned;
  json["chi2_lower_bound"] = certificate.own_lower_bound;
  return json;
}

std::string graph_file_name(const GraphRun& run) {
  return run.file.format == GraphFormat::toro ? "graph.toro" : "graph.g2o";
}

}  // namespace

GraphRun run_graph(const std::string& path, GraphFile file, const GraphConfig& config) {
  GraphRun run{.file = std::move(file), .config = config};
  run.remarks = run.file.remarks;
  std::visit([&](const auto& graph) { optimize_graph(path, graph, run); }, run.file.graph);
  if (run.components > 1) {
    run.remarks.push_back(
        fmt::format("the graph has {} components that nothing joins: where they lie to each other "
                    "is not known, "
                    "each stays about its own first node",
                    run.components));
  }
  if (!run.converged) {
    run.remarks.push_back(
        fmt::format("not converged after {} iterations: a lower chi2 may be near; "
                    "'optimization.max_iterations' "
                    "allows more",
                    run.iterations));
  }
  return run;
}

std::string graph_json(const std::string& path, const GraphRun& run) {
  nlohmann::ordered_json off = nlohmann::ordered_json::array();
  std::size_t nodes = 0, edges = 0;
  std::visit(
      [&](const auto& graph) {
        nodes = graph.nodes.size();
        edges = graph.constraints.size();
        for (std::size_t i = 0; i < edges; ++i) {
          const auto& c = graph.constraints[i];
          if (run.weights[i] >= 0.5) continue;
          off.push_back({{"from", run.file.ids[static_cast<std::size_t>(c.from)]},
                         {"to", run.file.ids[static_cast<std::size_t>(c.to)]},
                         {"weight", run.weights[i]}});
        }
      },
      run.best);
  nlohmann::ordered_json json;
  json["mapbed"] = "graph";
  json["file"] = escaped_utf8(path);
  json["nodes"] = nodes;
  json["edges"] = edges;
  json["loop_closures"] = run.loop_closures;
  json["components"] = run.components;
  if (run.file.has_poses) json["chi2_of_file"] = run.file_chi2;
  json["start"] = run.start_name;
  json["chi2_before"] = run.start_chi2;
  json["chi2_after"] = run.chi2;
  json["iterations"] = run.iterations;
  json["converged"] = run.converged;
  json["seconds"] = run.seconds;
  if (run.certificate) json["certificate"] = certificate_json(*run.certificate);
  json["switched_off"] = off;
  json["remarks"] = run.remarks;
  return json.dump(2) + "\n";
}

std::string graph_picture(const std::string& path, const GraphRun& run) {
  const std::size_t edges =
      std::visit([](const auto& graph) { return graph.constraints.size(); }, run.best);
  const std::string subtitle = fmt::format("{} nodes, {} edges, of which {} close loops",
                                           run.file.ids.size(), edges, run.loop_closures);
  const GraphPanel before =
      run.file.has_poses
          ? GraphPanel{fmt::format("as in the file: χ² = {:.5g}", run.file_chi2), run.file.graph}
          : GraphPanel{fmt::format("{}: χ² = {:.5g}", run.start_name, run.start_chi2), run.start};
  return graph_svg(
      fs::path(path).filename().string(), subtitle,
      {before, {fmt::format("optimised: χ² = {:.5g}", run.chi2), run.best, run.weights}});
}

void write_graph_run(const std::string& folder, const std::string& path, const GraphRun& run) {
  const auto at = [&](const std::string& name) { return (fs::path(folder) / name).string(); };
  write_graph(at(graph_file_name(run)), run.best, run.file.ids);
  write_file(at("picture.svg"), graph_picture(path, run));
  GraphConfig config = run.config;
  write_file(at("config.yaml"), to_yaml(options_of(config)));
  write_file(at(kReport), graph_json(path, run));
}

void refuse_foreign_graph_files(const std::string& folder, const std::string& path) {
  const std::vector<std::string> coming{"graph.g2o", "graph.toro", kReport, "picture.svg",
                                        "config.yaml"};
  std::ifstream file(fs::path(folder) / kReport);
  const auto json = nlohmann::json::parse(file, nullptr, false);
  const bool is_ours = json.is_object() && json.contains("mapbed") && json["mapbed"] == "graph" &&
                       json.contains("file") && json["file"].is_string();
  refuse_foreign(folder, coming, is_ours ? coming : std::vector<std::string>{});
  if (!is_ours || json["file"] == escaped_utf8(path)) return;
  std::error_code error;
  const std::string other = json["file"].get<std::string>();
  if (fs::equivalent(other, path, error)) return;
  refuse_of_another_log(folder, "the graph", other, "", "name a folder with --out");
}

}  // namespace mapbed
