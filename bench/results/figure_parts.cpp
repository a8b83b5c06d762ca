#include "bench/results/figure_parts.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/config/quantity.h"

namespace mapbed {
namespace {

// The values of an axis that the plot keeps to; null: all.
const std::vector<std::string>* values_at(const PlotSpec& spec, const std::string& path) {
  for (const auto& [of, values] : spec.at) {
    if (of == path) return &values;
  }
  return nullptr;
}

}  // namespace

Axis metric_axis(const std::string& name, Unit unit, const std::string& label, bool logarithmic) {
  return {label.empty() ? words_of(name) : label, display_symbol(unit), logarithmic};
}

Axis swept_axis(const SweepAxis& axis, const std::string& label, bool logarithmic) {
  return {label.empty() ? words_of(axis.path) : label, axis.unit, logarithmic};
}

bool is_shown(const Results& results, const PlotSpec& spec, int variant) {
  const bool was_run =
      results.skipped.empty() ||
      std::any_of(results.summary.begin(), results.summary.end(),
                  [&](const SummaryRow& row) { return row.variant == variant && row.runs > 0; });
  if (!was_run) return false;
  const std::string& name = results.variants[static_cast<std::size_t>(variant)];
  return spec.variants.empty() ||
         std::find(spec.variants.begin(), spec.variants.end(), name) != spec.variants.end();
}

bool is_shown(const Results& results, const PlotSpec& spec, int level, int variant) {
  const Level& at = results.levels[static_cast<std::size_t>(level)];
  for (std::size_t i = 0; i < results.axes.size(); ++i) {
    const std::vector<std::string>* values = values_at(spec, results.axes[i].path);
    if (values == nullptr) continue;
    const std::string& value = results.axes[i].texts[static_cast<std::size_t>(at.choice[i])];
    if (std::find(values->begin(), values->end(), value) == values->end()) return false;
  }
  return is_shown(results, spec, variant);
}

std::string line_name(const Results& results, const PlotSpec& spec, int level, int variant,
                      int x_axis) {
  std::string name = results.variants.size() > 1 && x_axis != kVariantsAlongX
                         ? results.variants[static_cast<std::size_t>(variant)]
                         : "";
  const Level& at = results.levels[static_cast<std::size_t>(level)];
  for (std::size_t axis = 0; axis < results.axes.size(); ++axis) {
    const SweepAxis& swept = results.axes[axis];
    const std::vector<std::string>* values = values_at(spec, swept.path);
    const bool is_one = values != nullptr && values->size() == 1;
    if (static_cast<int>(axis) == x_axis || is_one) continue;
    name += (name.empty() ? "" : ", ") + words_of(swept.path) + " " +
            swept.texts[static_cast<std::size_t>(at.choice[axis])];
  }
  return name;
}

PlotSeries& line_of(Plot& plot, const std::string& name, Mark mark) {
  for (PlotSeries& series : plot.series) {
    if (series.name == name) return series;
  }
  plot.series.push_back({.name = name, .mark = mark});
  return plot.series.back();
}

void ShownRuns::add(const SummaryRow& row) {
  runs += row.runs;
  failed += row.failed;
  missing += row.missing;
  least = std::min(least, row.runs);
  most = std::max(most, row.runs);
}

std::string ShownRuns::runs_each(const std::string& several) const {
  if (most <= 1) return "one run each";
  const std::string count =
      least >= most ? fmt::to_string(most) : fmt::format("{} to {}", least, most);
  return fmt::format(fmt::runtime(several), count);
}

std::string subtitle_of(const PlotSpec& spec, const std::string& treatment,
                        const ShownRuns& shown) {
  std::string text = treatment;
  for (const auto& [path, values] : spec.at) {
    if (values.size() == 1) text += "; " + words_of(path) + " " + values.front();
  }
  if (shown.failed > 0) text += fmt::format("; {} of {} runs failed", shown.failed, shown.runs);
  if (shown.missing > 0) text += fmt::format("; {} without a value left out", shown.missing);
  if (!spec.thesis.empty()) text += "; beside " + spec.thesis;
  return text;
}

}  // namespace mapbed
