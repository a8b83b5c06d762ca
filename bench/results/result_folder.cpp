#include "bench/results/result_folder.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/config/config_node.h"
#include "core/file/text_file.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

CsvTable table_of(const fs::path& path) {
  if (!fs::exists(path)) return {};
  CsvTable table = parse_csv(path.string(), read_text_file(path.string()));
  if (table.empty()) throw InputError({path.string()}, "is empty");
  return table;
}

std::string text_of(const fs::path& path) {
  return fs::exists(path) ? read_text_file(path.string()) : "";
}

// Sorts as people do: "after_90_s" before "after_130_s".
std::string sort_key(const std::string& name) {
  constexpr std::size_t kDigits = 12;
  std::string key, number;
  const auto flush = [&] {
    if (!number.empty()) key.append(kDigits - std::min(kDigits, number.size()), '0').append(number);
    number.clear();
  };
  for (const char c : name) {
    if (c >= '0' && c <= '9') {
      number += c;
      continue;
    }
    flush();
    key += c;
  }
  flush();
  return key;
}

std::vector<NamedFile> files_of(const fs::path& folder, const std::string& extension) {
  std::vector<NamedFile> files;
  if (!fs::is_directory(folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file() || entry.path().extension() != extension) continue;
    files.push_back(
        {entry.path().lexically_relative(folder).string(), read_text_file(entry.path().string())});
  }
  std::sort(files.begin(), files.end(), [](const NamedFile& a, const NamedFile& b) {
    return std::pair(sort_key(a.name), a.name) < std::pair(sort_key(b.name), b.name);
  });
  return files;
}

// What the scenario was about, from the complete configuration.
void read_head(const fs::path& path, ResultFolder& result) {
  const ConfigNode file = load_config(path.string());
  const ConfigNode* inner = file.find("scenario");
  const ConfigNode& scenario =
      inner != nullptr && inner->kind() == ConfigNode::Kind::map ? *inner : file;
  const auto text = [&](const char* key) {
    const ConfigNode* node = scenario.find(key);
    return node != nullptr && node->kind() == ConfigNode::Kind::value ? node->text() : "";
  };
  if (const std::string id = text("id"); !id.empty()) result.id = id;
  result.about = text("about");
  result.thesis = text("thesis");
  result.quick = text("quick") == "true";
  if (const ConfigNode* skipped = scenario.find("skipped")) result.skipped = skipped->texts();
}

// Those of all runs, in the scenario's order, before those of single ones.
void put_plots_first(const fs::path& config, std::vector<NamedFile>& figures) {
  const ConfigNode file = load_config(config.string());
  const ConfigNode* scenario = file.find("scenario");
  const ConfigNode* plots = scenario == nullptr ? nullptr : scenario->find("plots");
  if (plots == nullptr) return;
  std::vector<std::string> order;
  for (const ConfigNode& plot : plots->items()) order.push_back(plot.at("file").text() + ".svg");
  const auto place = [&](const NamedFile& figure) {
    return std::find(order.begin(), order.end(), figure.name) - order.begin();
  };
  std::stable_sort(figures.begin(), figures.end(),
                   [&](const NamedFile& a, const NamedFile& b) { return place(a) < place(b); });
}

}  // namespace

std::string field(const CsvTable& table, std::size_t row, const std::string& column) {
  if (table.empty()) return {};
  const CsvRow& head = table.front();
  const auto found = std::find(head.begin(), head.end(), column);
  return found == head.end() ? "" : table[row][static_cast<std::size_t>(found - head.begin())];
}

bool is_result_folder(const std::string& folder) {
  return fs::is_regular_file(fs::path(folder) / "config.yaml") &&
         fs::is_regular_file(fs::path(folder) / "summary.csv");
}

std::vector<std::string> result_folders(const std::string& folder) {
  if (!fs::is_directory(folder)) throw InputError({folder}, "there is no such folder");
  if (is_result_folder(folder)) return {folder};
  std::vector<std::string> folders;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (is_result_folder(entry.path().string())) folders.push_back(entry.path().string());
  }
  if (folders.empty()) {
    throw InputError({folder}, "holds no results: no folder with a config.yaml and a summary.csv",
                     "make some with 'mapbed run SCENARIO'");
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

ResultFolder load_result_folder(const std::string& folder) {
  const fs::path base(folder);
  if (!is_result_folder(folder)) {
    throw InputError({folder}, "is no folder of results: it has no config.yaml and summary.csv",
                     "make one with 'mapbed run SCENARIO'");
  }
  ResultFolder result{.folder = folder};
  result.id = fs::absolute(base / ".").lexically_normal().parent_path().filename().string();
  read_head(base / "config.yaml", result);
  result.claims = table_of(base / "claims.csv");
  const CsvTable of_cost = table_of(base / "cost_claims.csv");
  if (!of_cost.empty())
    result.claims.insert(result.claims.end(), of_cost.begin() + 1, of_cost.end());
  result.summary = table_of(base / "summary.csv");
  result.runs = table_of(base / "runs.csv");
  result.cost = table_of(base / "cost.csv");
  result.figures = files_of(base / "figures", ".svg");
  put_plots_first(base / "config.yaml", result.figures);
  result.maps = files_of(base / "maps", ".png");
  result.replays = files_of(base / "replays", ".json");
  result.config = text_of(base / "config.yaml");
  result.provenance = text_of(base / "provenance.json");
  return result;
}

ClaimCount claims_of(const ResultFolder& result) {
  ClaimCount count;
  for (std::size_t row = 1; row < result.claims.size(); ++row) {
    const std::string held = field(result.claims, row, "held");
    ++(held == "yes" ? count.held : held == "no" ? count.not_held : count.not_judged);
  }
  return count;
}

RunCount runs_of(const ResultFolder& result) {
  RunCount count;
  for (std::size_t row = 1; row < result.runs.size(); ++row) {
    ++count.runs;
    count.failed += field(result.runs, row, "failure").empty() ? 0 : 1;
  }
  return count;
}

}  // namespace mapbed
