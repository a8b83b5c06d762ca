#include <cstdio>
#include <deque>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench/cli/command_line.h"
#include "bench/cli/commands.h"
#include "bench/cli/progress.h"
#include "bench/pages/paper_table.h"
#include "bench/pages/reports.h"
#include "bench/process/folder_lock.h"
#include "bench/results/result_folder.h"
#include "bench/scenario/publication.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

// Those that a run is at work in are told and given back; the others are held, and what a program
// that was killed has begun there is ended.
std::set<std::string> lock_results(const std::string& folder, std::deque<FolderLock>& held) {
  std::set<std::string> busy;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string result = entry.path().string();
    if (!is_result_folder(result) && !is_being_published(result)) continue;
    try {
      held.emplace_back(result);
    } catch (const InputError& error) {
      fmt::print(stderr, "remark: {}; what it holds is left as it is\n", error.what());
      busy.insert(result);
      continue;
    }
    finish_publication(result);
  }
  return busy;
}

void report(const std::string& folder) {
  if (!fs::is_directory(folder)) throw InputError({folder}, "there is no such folder");
  const auto pages = while_told("writing pages", [&] {
    std::deque<FolderLock> held;
    held.emplace_back(folder);
    finish_publication(folder);
    const std::set<std::string> busy = lock_results(folder, held);
    return write_reports(folder, busy);
  });
  for (const std::string& page : pages) fmt::print("written: {}\n", page);
}

struct ReportArguments {
  std::vector<std::string> folders;
  std::string table;
  std::vector<std::string> metrics;
};

// Those of each result below the folder.
void print_tables(const std::string& folder, const ReportArguments& arguments) {
  for (const std::string& result : result_folders(folder)) {
    for (const PaperTable& table : paper_tables(load_results(result), arguments.metrics)) {
      fmt::print("{}\n", arguments.table == "latex" ? latex_of(table) : markdown_of(table));
    }
  }
}

}  // namespace

Command report_command() {
  const auto arguments = std::make_shared<ReportArguments>();
  return {
      .name = "report",
      .help = "Write pages that show results, and one over all of them",
      .options = {{"FOLDER", &arguments->folders,
                   "a scenario's results, or a folder of such; 'results' where left out. Judges "
                   "the claims and draws the figures again from the tables, and writes "
                   "report.html into each, and README.md into the folder of all"},
                  {.name = "--table",
                   .target = &arguments->table,
                   .help = "print the summary as tables of that form, variants side by side, and "
                           "write nothing",
                   .check = std::vector<std::string>{"latex", "markdown"}},
                  {.name = "--metric",
                   .target = &arguments->metrics,
                   .help = "of the tables, as summary.csv names it; may come again; all of them "
                           "where left out",
                   .needs = "--table"}},
      .run = [arguments] {
        if (arguments->folders.empty()) arguments->folders.push_back("results");
        for (const std::string& folder : arguments->folders) {
          if (arguments->table.empty()) {
            report(folder);
          } else {
            print_tables(folder, *arguments);
          }
        }
        return kDone;
      }};
}

}  // namespace mapbed
