#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench/cli/certificate_report.h"
#include "bench/cli/command_line.h"
#include "bench/cli/commands.h"
#include "bench/cli/graph_run.h"
#include "bench/cli/output_folder.h"
#include "bench/cli/progress.h"
#include "bench/process/folder_lock.h"
#include "bench/process/process_cost.h"
#include "bench/process/stopwatch.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

struct GraphArguments {
  std::string file;
  std::string config_file;
  std::string folder;
  std::vector<std::string> settings;
};

GraphConfig config_from(const GraphArguments& arguments) {
  Settings settings;
  if (!arguments.config_file.empty()) settings = load_settings(arguments.config_file);
  for (const std::string& text : arguments.settings) settings.push_back(parse_setting(text));
  GraphConfig config;
  apply(settings, options_of(config), "");
  return config;
}

// "intel.g2o.gz" -> "intel_graph"
std::string folder_for(const GraphArguments& arguments) {
  if (!arguments.folder.empty()) return arguments.folder;
  fs::path file = fs::path(arguments.file).filename();
  if (file.extension() == ".gz") file = file.stem();
  return file.stem().string() + "_graph";
}

void print_report(const std::string& path, const GraphRun& run, double reading) {
  const std::size_t edges =
      std::visit([](const auto& graph) { return graph.constraints.size(); }, run.best);
  fmt::print("{}: {} nodes, {} edges, {} of which close loops, {} component{}; read in {:.2f} s\n",
             path, run.file.ids.size(), edges, run.loop_closures, run.components,
             run.components == 1 ? "" : "s", reading);
  for (const std::string& remark : run.remarks) fmt::print(stderr, "remark: {}\n", remark);
  if (run.file.has_poses) fmt::print("chi2 of the file's poses: {:.6g}\n", run.file_chi2);
  fmt::print("chi2: {:.6g} from {}, {:.9g} after {} iterations{}; {:.1f} ms\n", run.start_chi2,
             run.start_name, run.chi2, run.iterations, run.converged ? "" : " (not converged)",
             1e3 * run.seconds);
  if (run.certificate) {
    fmt::print("{}; {:.1f} ms\n", certificate_text(*run.certificate),
               1e3 * run.certificate_seconds);
  }
  if (run.config.optimization.robust.loss == RobustLoss::none) return;
  int off = 0;
  for (const double weight : run.weights) off += weight < 0.5;
  fmt::print("switched off, by a weight below one half: {} of {} loop closures\n", off,
             run.loop_closures);
}

int optimize_file(const GraphArguments& arguments) {
  const Stopwatch stopwatch;
  const GraphConfig config = config_from(arguments);
  const std::string folder = folder_for(arguments);
  {
    const OutputFolder probe(folder);
    const FolderLock lock(folder);
    refuse_foreign_graph_files(folder, arguments.file);
  }
  GraphFile file = while_told("reading", [&] { return load_graph(arguments.file, config.file); });
  const double reading = stopwatch.seconds();
  const GraphRun run =
      while_told("optimising", [&] { return run_graph(arguments.file, std::move(file), config); });
  const OutputFolder made(folder);
  const FolderLock lock(folder);
  write_graph_run(folder, arguments.file, run);
  print_report(arguments.file, run, reading);
  fmt::print("all {:.2f} s; {:.0f} MB\nwritten to {}\n", stopwatch.seconds(), peak_memory() / 1e6,
             folder);
  return kDone;
}

}  // namespace

Command graph_command() {
  const auto arguments = std::make_shared<GraphArguments>();
  return {.name = "graph",
          .help = "Optimise a pose graph",
          .options = {{.name = "FILE",
                       .target = &arguments->file,
                       .help = "g2o or TORO, in the plane or in space, also gzipped; edges alone "
                               "are enough",
                       .is_required = true},
                      {"--set", &arguments->settings,
                       "path=value, any option that 'mapbed describe graph_file' shows: "
                       "optimization.robust.loss=graduated_truncated; may come again"},
                      {"--config", &arguments->config_file,
                       "YAML with such options, as config.yaml in a result's folder"},
                      {"-o,--out", &arguments->folder,
                       "folder for the results; FILE's name and '_graph' here where left out"}},
          .run = [arguments] { return optimize_file(*arguments); }};
}

}  // namespace mapbed
