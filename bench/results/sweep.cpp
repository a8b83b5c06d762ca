#include "bench/results/sweep.h"

#include <algorithm>

#include <fmt/format.h>

#include "bench/results/flow_text.h"
#include "core/config/config_node.h"
#include "core/config/suggestion.h"
#include "core/file/parse_number.h"

namespace mapbed {
namespace {

constexpr double kMostLevels = 1e6;

// "2 deg" is 2 and "deg"; false where the text does not begin with a number.
bool split_quantity(const std::string& text, double& number, std::string& unit) {
  const char* const end = read_number(text.data(), text.data() + text.size(), number);
  if (end == nullptr) return false;
  unit.assign(end, text.data() + text.size());
  unit.erase(0, unit.find_first_not_of(' '));
  return unit.empty() || *end == ' ';
}

}  // namespace

SweepAxis axis_of(const std::string& path, std::vector<std::string> texts) {
  SweepAxis axis{path, std::move(texts), {}, {}};
  for (std::size_t i = 0; i < axis.texts.size(); ++i) {
    double number = 0.0;
    std::string unit;
    if (!split_quantity(axis.texts[i], number, unit)) return {path, axis.texts, {}, {}};
    if (i == 0) axis.unit = unit;
    if (unit != axis.unit) return {path, axis.texts, {}, {}};
    axis.numbers.push_back(number);
  }
  return axis;
}

SweepAxis named_axis_of(const std::string& path, const ConfigNode& names) {
  SweepAxis axis = axis_of(path, names.keys());
  axis.place = names.place();
  for (const std::string& name : axis.texts) axis.sets.push_back(settings_of(names.at(name)));
  return axis;
}

std::string names_text(const SweepAxis& axis) {
  std::vector<std::pair<std::string, std::string>> names;
  for (std::size_t i = 0; i < axis.texts.size(); ++i) {
    std::vector<std::pair<std::string, std::string>> set;
    for (const Setting& setting : axis.sets[i]) {
      set.emplace_back(flow_scalar(setting.path), flow_scalar(setting.text));
    }
    names.emplace_back(flow_scalar(axis.texts[i]), set.empty() ? "{}" : flow_map(set));
  }
  return flow_map(names);
}

SweepAxis with_values(const SweepAxis& axis, const std::vector<std::string>& texts,
                      const SourceLocation& place) {
  SweepAxis result = axis_of(axis.path, texts);
  result.place = place;
  if (axis.sets.empty()) return result;
  for (const std::string& text : texts) {
    const auto found = std::find(axis.texts.begin(), axis.texts.end(), text);
    if (found == axis.texts.end()) {
      throw InputError(place, in_quotes(text) + " is no value of the sweep of '" + axis.path + "'",
                       suggestion(text, axis.texts));
    }
    result.sets.push_back(axis.sets[static_cast<std::size_t>(found - axis.texts.begin())]);
  }
  return result;
}

Settings settings_at(const SweepAxis& axis, int choice) {
  const auto index = static_cast<std::size_t>(choice);
  if (!axis.sets.empty()) return axis.sets[index];
  return {{axis.path, axis.texts[index], axis.place}};
}

std::vector<Level> levels_of(const std::vector<SweepAxis>& axes) {
  double count = 1.0;
  for (const SweepAxis& axis : axes) count *= static_cast<double>(axis.texts.size());
  if (count > kMostLevels) {
    throw InputError(fmt::format(
        "the sweep has {:.3g} levels, of {:.3g} at most; take fewer values", count, kMostLevels));
  }
  std::vector<Level> levels{Level{}};
  for (const SweepAxis& axis : axes) {
    std::vector<Level> finer;
    for (const Level& level : levels) {
      for (std::size_t i = 0; i < axis.texts.size(); ++i) {
        finer.push_back(level);
        finer.back().choice.push_back(static_cast<int>(i));
      }
    }
    levels = std::move(finer);
  }
  return levels;
}

std::string words_of(const std::string& path) {
  std::string name = path.substr(path.rfind('.') + 1);
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

}  // namespace mapbed
