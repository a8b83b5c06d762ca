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
        if (folders->empty()) folders->push_back("results");
        for (const std::string& folder : *folders) report(folder);
        return kDone;
      }};
}

}  // namespace mapbed
