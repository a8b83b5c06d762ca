#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench/cli/command_line.h"
#include "bench/cli/commands.h"
#include "bench/pages/overview_page.h"
#include "bench/results/figures.h"
#include "bench/results/judge.h"
#include "bench/results/result_folder.h"

namespace mapbed {
namespace {

int report(const std::vector<std::string>& folders) {
  for (const std::string& folder : folders) {
    for (const std::string& result : result_folders(folder)) {
      Results results = load_results(result);
      if (judge_again(results)) write_results(result, results);
      write_figures(result, results);
    }
    for (const std::string& path : write_reports(folder)) fmt::print("written: {}\n", path);
  }
  return kDone;
}

}  // namespace

Command report_command() {
  const auto folders = std::make_shared<std::vector<std::string>>();
  return {
      .name = "report",
      .help = "Write pages that show results, and one over all of them",
      .options = {{"FOLDER", folders.get(),
                   "a scenario's results, or a folder of such; 'results' where left out. Judges "
                   "the claims and draws the figures again from the tables, and writes "
                   "report.html into each, and README.md into the folder of all"}},
      .run = [folders] {
        return report(folders->empty() ? std::vector<std::string>{"results"} : *folders);
      }};
}

}  // namespace mapbed
