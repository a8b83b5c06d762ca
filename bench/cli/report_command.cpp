#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "bench/cli/command_line.h"
#include "bench/cli/commands.h"
#include "bench/cli/progress.h"
#include "bench/pages/overview_page.h"
#include "bench/process/folder_lock.h"
#include "bench/results/figures.h"
#include "bench/results/judge.h"
#include "bench/results/result_folder.h"
#include "bench/scenario/publication.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

// Nothing, and a remark, where a run is at work in that folder.
std::unique_ptr<FolderLock> lock_of(const std::string& folder) {
  try {
    return std::make_unique<FolderLock>(folder);
  } catch (const InputError& error) {
    fmt::print(stderr, "remark: {}; what it holds is left as it is\n", error.what());
    return nullptr;
  }
}

// Of results whose run was killed in its last step.
void finish_publications(const std::string& folder) {
  const auto finish = [](const std::string& result) {
    if (!is_being_published(result)) return;
    if (const auto lock = lock_of(result)) finish_publication(result);
  };
  finish(folder);
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.is_directory(error)) finish(entry.path().string());
  }
}

// Verdicts and figures from the tables.
void make_again(const std::string& result) {
  const auto lock = lock_of(result);
  if (!lock) return;
  Results results = load_results(result);
  if (judge_again(results)) write_results(result, results);
  write_figures(result, results);
}

int report(const std::vector<std::string>& folders) {
  for (const std::string& folder : folders) {
    const auto pages = while_told("writing pages", [&] {
      finish_publications(folder);
      refuse_foreign_pages(folder);
      for (const std::string& result : result_folders(folder)) make_again(result);
      return write_reports(folder);
    });
    for (const std::string& path : pages) fmt::print("written: {}\n", path);
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
