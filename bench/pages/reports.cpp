#include "bench/pages/reports.h"

#include <deque>
#include <filesystem>

#include "bench/pages/html.h"
#include "bench/pages/overview_page.h"
#include "bench/pages/scenario_page.h"
#include "bench/process/foreign_files.h"
#include "bench/results/figures.h"
#include "bench/results/judge.h"
#include "bench/results/result_folder.h"
#include "bench/scenario/publication.h"
#include "core/file/atomic_file.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPage = "report.html";
constexpr const char* kMarkdown = "README.md";

std::string path_in(const std::string& folder, const char* name) {
  return (fs::path(folder) / name).string();
}

void refuse_if_foreign(const std::string& path, bool (*is_ours)(const std::string& path)) {
  if (fs::exists(path) && !is_ours(path)) refuse_foreign(path);
}

ReportedResults judged_and_drawn(const std::string& folder) {
  ReportedResults reported{folder, load_results(folder)};
  judge_again(reported.results);
  reported.drawn = figure_files(reported.results);
  return reported;
}

}  // namespace

void refuse_foreign_page(const std::string& folder) {
  refuse_if_foreign(path_in(folder, kPage), is_page_of_ours);
}

void refuse_foreign_pages(const std::string& folder) {
  for (const std::string& path : result_folders(folder)) refuse_foreign_page(path);
  if (is_result_folder(folder)) return;
  refuse_foreign_page(folder);
  refuse_if_foreign(path_in(folder, kMarkdown), is_markdown_of_ours);
}

void write_page(const std::string& folder) {
  refuse_foreign_page(folder);
  write_file(path_in(folder, kPage), scenario_page({folder, load_results(folder)}));
}

std::vector<std::string> write_reports(const std::string& folder,
                                       const std::set<std::string>& busy) {
  refuse_foreign_pages(folder);
  std::vector<std::string> pages;
  std::vector<ReportedResults> all;
  std::deque<Publication> coming;  // all are made before the first takes its place
  for (const std::string& path : result_folders(folder)) {
    if (busy.contains(path)) {
      all.push_back({path, load_results(path)});
      continue;
    }
    all.push_back(judged_and_drawn(path));
    coming.emplace_back(path, all.back().results, "", scenario_page(all.back()));
    pages.push_back(path_in(path, kPage));
  }
  if (!is_result_folder(folder)) {
    coming.emplace_back(folder, std::vector<ResultFile>{{kPage, overview_page(all)},
                                                        {kMarkdown, overview_markdown(all)}});
    for (const char* name : {kPage, kMarkdown}) pages.push_back(path_in(folder, name));
  }
  for (Publication& publication : coming) publication.commit();
  return pages;
}

}  // namespace mapbed
