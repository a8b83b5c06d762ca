#include "algorithms/people/learned_people.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "core/config/settings.h"
#include "core/data_path.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

std::string path_of(const std::string& name_or_path) {
  return find_data_file("people model", "algorithms/people/people_models", name_or_path).string();
}

SourceLocation place_of(const std::string& path, const Settings& settings,
                        const std::string& file) {
  const auto found = std::find_if(settings.begin(), settings.end(),
                                  [&](const Setting& setting) { return setting.path == path; });
  return found == settings.end() ? SourceLocation{file} : found->place;
}

// Every number of the table of evidence, and no gap in the numbers of people.
void check(const LearnedPeople& learned, const Settings& settings, const std::string& file) {
  const auto check_four = [&](const std::string& path, const std::vector<double>& values,
                              const char* of) {
    if (values.size() == 4) return;
    throw InputError(place_of(path, settings, file),
                     fmt::format("'{}' has {} values", path, values.size()),
                     fmt::format("it needs four: {}", of));
  };
  constexpr const char* kLeft = "he is still about where he was, unknown, free, the same";
  for (std::size_t i = 0; i < kSeenBeforeNames.size(); ++i) {
    const std::string before(kSeenBeforeNames[i]);
    check_four("steady_step." + before, learned.steady_step[i], kLeft);
    check_four("unsteady_step." + before, learned.unsteady_step[i], kLeft);
  }
  check_four("stay", learned.stay, "by what stood there: nothing, free, mixed, same");
  const auto is_set = [&](const std::string& path) {
    return !place_of(path, settings, "").file.empty();
  };
  if (!is_set("missed")) throw InputError({file}, "has no 'missed'");
  bool is_over = false;
  for (std::size_t n = 0; n < learned.scans.size(); ++n) {
    const std::vector<double>& row = learned.scans[n];
    const std::string path = fmt::format("scans.people_{}", n);
    if (n == 0 && row.empty()) throw InputError({file}, "has no '" + path + "'");
    if (!row.empty() && is_over) {
      throw InputError(place_of(path, settings, file),
                       fmt::format("there is '{}', but no 'scans.people_{}'", path, n - 1));
    }
    is_over = row.empty();
  }
}

}  // namespace

double LearnedPeople::log_ratio(const Evidence& evidence) const {
  const auto row = static_cast<std::size_t>(evidence.before);
  if (evidence.kind == Evidence::Kind::missed) return missed;
  if (evidence.kind == Evidence::Kind::stay) return stay[row];
  const Table& table = evidence.is_steady ? steady_step : unsteady_step;
  return table[row][static_cast<std::size_t>(evidence.left)];
}

FeatureNumbers LearnedPeople::feature_numbers(double detection, double false_alarms,
                                              int max_people) const {
  const FeatureNumbers form = FeatureNumbers::closed_form(detection, false_alarms, max_people);
  std::vector<std::vector<double>> rows;
  for (int n = 0; n <= max_people; ++n) {
    const auto row_of_n = static_cast<std::size_t>(n);
    const std::vector<double> counted =
        row_of_n < scans.size() ? scans[row_of_n] : std::vector<double>{};
    double all = closed_form;
    for (const double count : counted) all += count;
    std::vector<double>& row = rows.emplace_back();
    for (int m = 0; m <= form.max_features(); ++m) {
      const auto column = static_cast<std::size_t>(m);
      const double count = column < counted.size() ? counted[column] : 0.0;
      row.push_back((count + closed_form * form.probability(m, n)) / all);
    }
  }
  return FeatureNumbers(std::move(rows));
}

LearnedPeople load_learned_people(const std::string& name_or_path) {
  const std::string path = path_of(name_or_path);
  const Settings settings = load_settings(path);
  LearnedPeople learned;
  apply(settings, options_of(learned), "people model");
  check(learned, settings, path);
  return learned;
}

InputFile learned_people_file(const std::string& name_or_path) {
  return input_file(path_of(name_or_path));
}

std::string to_yaml(LearnedPeople learned,
                    const std::vector<std::pair<std::string, std::string>>& counts) {
  OptionList options = options_of(learned);
  std::erase_if(options, [&](const Option& option) {
    return option.path.starts_with("scans.") &&
           std::get<std::vector<double>*>(option.value)->empty();
  });
  for (const auto& [path, words] : counts) {
    for (Option& option : options) {
      if (option.path == path) option.about = words;
    }
  }
  return to_yaml(options);
}

}  // namespace mapbed
