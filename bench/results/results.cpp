#include "bench/results/results.h"

#include <algorithm>

namespace mapbed {
namespace {

template <class Things, class Name>
int index_of(const Things& things, const std::string& name, Name&& name_of) {
  const auto found = std::find_if(things.begin(), things.end(),
                                  [&](const auto& thing) { return name_of(thing) == name; });
  return found == things.end() ? -1 : static_cast<int>(found - things.begin());
}

const std::string& text_at(const Results& results, int level, std::size_t axis) {
  const Level& at = results.levels[static_cast<std::size_t>(level)];
  return results.axes[axis].texts[static_cast<std::size_t>(at.choice[axis])];
}

}  // namespace

int metric_index(const Results& results, const std::string& name) {
  return index_of(results.metrics, name, [](const Metric& m) { return m.name; });
}

int series_index(const Results& results, const std::string& name) {
  return index_of(results.series_metrics, name, [](const SeriesMetric& m) { return m.name; });
}

int variant_index(const Results& results, const std::string& name) {
  return index_of(results.variants, name, [](const std::string& v) { return v; });
}

int axis_index(const Results& results, const std::string& path) {
  return index_of(results.axes, path, [](const SweepAxis& a) { return a.path; });
}

std::string level_text(const Results& results, int level) {
  std::string text;
  for (std::size_t axis = 0; axis < results.axes.size(); ++axis) {
    const std::string& path = results.axes[axis].path;
    text += (text.empty() ? "" : ", ") + path.substr(path.rfind('.') + 1) + " = " +
            text_at(results, level, axis);
  }
  return text.empty() ? "all" : text;
}

std::string run_words(const Results& results, const RunRow& run) {
  std::string text;
  for (std::size_t axis = 0; axis < results.axes.size(); ++axis) {
    if (results.axes[axis].texts.size() < 2) continue;
    text += (text.empty() ? "" : ", ") + words_of(results.axes[axis].path) + " " +
            text_at(results, run.level, axis);
  }
  if (results.variants.size() < 2) return text;
  return text + (text.empty() ? "" : ", ") +
         results.variants[static_cast<std::size_t>(run.variant)];
}

}  // namespace mapbed
