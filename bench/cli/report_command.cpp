#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "bench/cli/commands.h"
#include "bench/pages/overview_page.h"
#include "bench/results/figures.h"
#include "bench/results/results_file.h"

namespace mapbed {

void add_report_command(CLI::App& program, Action& action) {
  CLI::App* command =
      program.add_subcommand("report", "Write pages that show results, and one over all of them");
  const auto folders = std::make_shared<std::vector<std::string>>();
  command->add_option("FOLDER", *folders,
                      "a scenario's results, or a folder of such; 'results' where left out. Draws "
                      "the figures from the tables again and writes report.html into each, and "
                      "README.md into the folder of all");
  command->callback([folders, &action] {
    action = [folders] {
      if (folders->empty()) folders->push_back("results");
      for (const std::string& folder : *folders) {
        for (const std::string& result : result_folders(folder)) {
          write_figures(result, load_results(result));
        }
        for (const std::string& path : write_reports(folder)) fmt::print("written: {}\n", path);
      }
      return static_cast<int>(kDone);
    };
  });
}

}  // namespace mapbed
