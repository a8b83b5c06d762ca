#include "bench/scenario/failed_runs.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "bench/results/results.h"

namespace mapbed {
namespace {

constexpr std::size_t kShown = 5;  // reasons

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

// "12.5 m off after 3 s" -> "# m off after # s"
std::string without_numbers(const std::string& reason) {
  std::string text;
  for (std::size_t i = 0; i < reason.size(); ++i) {
    const bool in_number = i > 0 && i + 1 < reason.size() && reason[i] == '.' &&
                           is_digit(reason[i - 1]) && is_digit(reason[i + 1]);
    if (!is_digit(reason[i]) && !in_number) {
      text += reason[i];
    } else if (text.empty() || text.back() != '#') {
      text += '#';
    }
  }
  return text;
}

struct Reason {
  std::string example;  // of the first run that has it
  int first_run = 0;
  int count = 0;
};

std::vector<Reason> reasons_of(const Results& results) {
  std::map<std::string, Reason> by_form;
  for (const RunRow& run : results.runs) {
    if (run.failure.empty()) continue;
    Reason& reason = by_form[without_numbers(run.failure)];
    if (reason.count++ == 0) reason = {run.failure, run.run, 1};
  }
  std::vector<Reason> reasons;
  for (auto& [form, reason] : by_form) reasons.push_back(std::move(reason));
  std::stable_sort(reasons.begin(), reasons.end(),
                   [](const Reason& a, const Reason& b) { return a.count > b.count; });
  return reasons;
}

}  // namespace

std::string failed_runs_text(const Results& results, const std::string& folder) {
  const std::vector<Reason> reasons = reasons_of(results);
  if (reasons.empty()) return "";
  std::string text =
      "failed: these runs did not come to what they should (the method was lost or stopped, or the "
      "log could not be made); they stay in the tables and count as failures\n";
  for (std::size_t i = 0; i < std::min(kShown, reasons.size()); ++i) {
    const Reason& reason = reasons[i];
    text += fmt::format("  {:>4} x {} (run {})\n", reason.count, reason.example, reason.first_run);
  }
  if (reasons.size() > kShown) text += fmt::format("  and {} more\n", reasons.size() - kShown);
  const bool has_messages =
      std::any_of(results.files.begin(), results.files.end(),
                  [](const FileOfRun& file) { return file.path.starts_with("messages/"); });
  return text + fmt::format(
                    "  all of them: {0}/runs.csv, column failure{1}; 'mapbed run … --run "
                    "NUMBER' repeats one\n",
                    folder, has_messages ? "; what programs said: " + folder + "/messages" : "");
}

}  // namespace mapbed
