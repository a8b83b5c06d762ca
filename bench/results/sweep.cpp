#include "bench/results/sweep.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/file/parse_number.h"
#include "core/input_error.h"

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
