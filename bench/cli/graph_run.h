#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algorithms/pose_graph/certificate.h"
#include "algorithms/pose_graph/graph_file.h"
#include "algorithms/pose_graph/graph_optimizer.h"
#include "core/config/settings.h"

namespace mapbed {

// Where `mapbed graph` begins.
enum class GraphStart : int {
  best,  // the file's poses or the chordal ones, whichever cost less
  file,
  chordal,
  spanning_tree
};

struct GraphConfig {
  GraphStart start = GraphStart::best;
  bool certify = true;
  GraphFileOptions file;
  GraphOptimizationOptions optimization;
};

template <class Visitor>
void visit_fields(GraphConfig& o, Visitor&& visit) {
  visit("start", o.start, {"best", "file", "chordal", "spanning_tree"},
        "poses that it begins with: the file's, chordal ones, those along a spanning tree, or the "
        "better of the first two");
  visit("certify", o.certify,
        "whether it is looked into if the optimum is the global one, where nothing is doubted");
  visit("file", o.file, "how the file is read");
  visit("optimization", o.optimization, "how the graph is optimised");
}

struct GraphRun {
  GraphFile file;
  GraphConfig config;
  AnyPoseGraph start;  // the graph with the poses that it began with
  AnyPoseGraph best;
  std::string start_name;  // "the file's poses"
  double file_chi2 = 0.0;  // where it has poses
  double start_chi2 = 0.0;
  double chi2 = 0.0;
  int loop_closures = 0;
  int components = 0;
  int iterations = 0;
  bool converged = false;
  double seconds = 0.0;  // start and optimisation
  std::vector<double> weights;
  std::optional<Certificate> certificate;
  double certificate_seconds = 0.0;
  std::vector<std::string> remarks;
};

// Throws InputError where the start is to be the file's and it has no poses.
GraphRun run_graph(const std::string& path, GraphFile file, const GraphConfig& config);

// graph.g2o or graph.toro, graph.json, picture.svg and config.yaml.
void write_graph_run(const std::string& folder, const std::string& path, const GraphRun& run);
std::string graph_json(const std::string& path, const GraphRun& run);
std::string graph_picture(const std::string& path, const GraphRun& run);

// Throws InputError, before the work, where the folder holds files that are not of a graph of ours,
// or are of another one.
void refuse_foreign_graph_files(const std::string& folder, const std::string& path);

}  // namespace mapbed
