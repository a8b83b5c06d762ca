#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "bench/cli/commands.h"
#include "bench/pages/overview_page.h"
#include "bench/results/figures.h"
#include "bench/results/judge.h"
#include "bench/results/result_folder.h"

namespace mapbed {

void add_report_command(CLI::App& program, Action& action) {
  CLI::App* command =
      program.add_subcommand("report", "Write pages that show results, and one over all of them");
  const auto folders = std::make_shared<std::vector<std::string>>();
  command->add_option("FOLDER", *folders,
                      "a scenario's results, or a folder of such; 'results' where left out. Judges "
                      "the claims and draws the figures again from the tables, and writes "
                      "report.html into each, and "
                      "README.md into the folder of all");
  command->callback([folders, &action] {
    action = [folders] {
      if (folders->empty()) folders->push_back("results");
      for (const std::string& folder : *folders) {
        for (const std::string& result : result_folders(folder)) {
          Results results = load_results(result);
          if (judge_again(results)) write_results(result, results);
          write_figures(result, results);
        }
        for (const std::string& path : write_reports(folder)) fmt::print("written: {}\n", path);
      }
      return static_cast<int>(kDone);
    };
  });
}

}  // namespace mapbed
