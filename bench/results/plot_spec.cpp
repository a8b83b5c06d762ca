#include "bench/results/plot_spec.h"

#include <algorithm>

#include "bench/results/flow_text.h"
#include "bench/results/results.h"
#include "core/config/quantity.h"
#include "core/config/suggestion.h"
#include "core/data_path.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

const std::vector<std::string> kKinds{"lines", "bars", "points", "heat_map", "series", "matrix"};

using Names = std::vector<std::string>;

Names axes_of(const Results& plan) {
  Names names;
  for (const SweepAxis& axis : plan.axes) names.push_back(axis.path);
  return names;
}

Names metrics_of(const Results& plan) {
  Names names;
  for (const Metric& metric : plan.metrics) names.push_back(metric.name);
  return names;
}

void check_name(const PlotSpec& plot, const std::string& name, const Names& known,
                const std::string& what) {
  if (name.empty() || std::find(known.begin(), known.end(), name) != known.end()) return;
  throw InputError(plot.place,
                   "the plot '" + plot.file + "' shows '" + name + "', which is " + what,
                   suggestion(name, known));
}

// Two of one name would be one file.
void check_file(const PlotSpec& plot, const Results& plan) {
  const auto same = std::count_if(plan.plots.begin(), plan.plots.end(),
                                  [&](const PlotSpec& p) { return p.file == plot.file; });
  if (same < 2) return;
  throw InputError(plot.place, "two plots have the name " + in_quotes(plot.file),
                   "give one of them another name, as in 'file: " + plot.file + "_2'");
}

// A quick run may lack some of the values.
void check_levels(const PlotSpec& plot, const Results& plan) {
  for (const auto& [path, values] : plot.at) {
    check_name(plot, path, axes_of(plan), "not swept here");
    if (plan.quick) continue;
    const auto axis = std::find_if(plan.axes.begin(), plan.axes.end(),
                                   [&path = path](const SweepAxis& a) { return a.path == path; });
    for (const std::string& value : values) {
      check_name(plot, value, axis->texts, "no value of '" + path + "'");
    }
  }
}

// Colours need numbers along both sides, and one value for each pair.
void check_heat_map(const PlotSpec& plot, const Results& plan) {
  for (const std::string& path : {plot.x, plot.y}) {
    check_name(plot, path, axes_of(plan), "not swept here");
    const auto axis = std::find_if(plan.axes.begin(), plan.axes.end(),
                                   [&](const SweepAxis& a) { return a.path == path; });
    if (!axis->numbers.empty()) continue;
    throw InputError(plot.place,
                     "the values of " + in_quotes(path) + " are not all numbers of one unit",
                     "a heat map needs such along both sides");
  }
  check_name(plot, plot.value, metrics_of(plan), "not measured here");
  const std::size_t variants = plot.variants.empty() ? plan.variants.size() : plot.variants.size();
  const auto fixed = std::count_if(plot.at.begin(), plot.at.end(),
                                   [](const auto& at) { return at.second.size() == 1; });
  const auto open = static_cast<std::ptrdiff_t>(plan.axes.size()) - fixed;
  if (plot.x == plot.y || open != 2 || variants != 1) {
    throw InputError(plot.place, "the heat map '" + plot.file + "' has no one value for each place",
                     "it shows one variant ('variants: [" + plan.variants.front() +
                         "]') over two axes, all that are swept but for those with 'at'");
  }
}

// Metrics of one unit, at one level.
void check_rows(const PlotSpec& plot, const Results& plan) {
  std::ptrdiff_t fixed = 0;
  for (const auto& at : plot.at) fixed += at.second.size() == 1 ? 1 : 0;
  if (fixed != static_cast<std::ptrdiff_t>(plan.axes.size())) {
    throw InputError(plot.place, "the matrix '" + plot.file + "' has no one value for each place",
                     "give one value of each axis that is swept with 'at'");
  }
  for (const std::string& metric : plot.rows) {
    check_name(plot, metric, metrics_of(plan), "not measured here");
    const auto unit_of = [&](const std::string& name) {
      return plan.metrics[static_cast<std::size_t>(metric_index(plan, name))].unit;
    };
    if (unit_of(metric) == unit_of(plot.rows.front())) continue;
    throw InputError(plot.place, "the rows of the matrix '" + plot.file + "' have several units",
                     "one scale of colours needs one unit");
  }
}

void check_value_range(const PlotSpec& plot, Unit unit) {
  for (const std::string& end : plot.value_range) (void)parse_quantity(end, unit, plot.place);
  if (plot.value_range.size() == 0 || plot.value_range.size() == 2) return;
  throw InputError(plot.place, "the value_range of '" + plot.file + "' has no two ends",
                   "write e.g. 'value_range: [1, 100]'");
}

void check_matrix(const PlotSpec& plot, const Results& plan) {
  const std::string& shown = plot.rows.empty() ? plot.value : plot.rows.front();
  if (!plot.rows.empty()) check_rows(plot, plan);
  for (const std::string& path : {plot.x, plot.y}) {
    check_name(plot, path, axes_of(plan), "not swept here");
  }
  for (const std::string& metric : {plot.value, plot.mark}) {
    check_name(plot, metric, metrics_of(plan), "not measured here");
  }
  check_value_range(plot, plan.metrics[static_cast<std::size_t>(metric_index(plan, shown))].unit);
  if (!plot.rows.empty()) return;
  const auto fixed = std::count_if(plot.at.begin(), plot.at.end(),
                                   [](const auto& at) { return at.second.size() == 1; });
  const std::ptrdiff_t open = static_cast<std::ptrdiff_t>(plan.axes.size()) - fixed;
  if (plot.x == plot.y || open > (plot.x.empty() ? 1 : 2)) {
    throw InputError(plot.place, "the matrix '" + plot.file + "' has no one value for each place",
                     "it shows all axes that are swept, along y and x, but for those with 'at'");
  }
}

void check_references(const PlotSpec& plot, Unit unit) {
  for (const PlotReference& reference : plot.references) {
    (void)parse_quantity(reference.value, unit, plot.place);
  }
}

// Along x is what the series itself goes over.
void check_series(const PlotSpec& plot, const Results& plan) {
  Names names;
  for (const SeriesMetric& metric : plan.series_metrics) names.push_back(metric.name);
  check_name(plot, plot.y, names, "not a series of this scenario");
  const SeriesMetric& metric =
      plan.series_metrics[static_cast<std::size_t>(series_index(plan, plot.y))];
  check_name(plot, plot.x, {metric.x_name}, "not what the series goes over");
  check_references(plot, metric.unit);
}

void read(const ConfigNode& node, const char* key, std::string& text) {
  if (const ConfigNode* found = node.find(key)) text = found->text();
}

void read_matrix(const ConfigNode& node, PlotSpec& plot) {
  if (const ConfigNode* rows = node.find("rows")) plot.rows = rows->texts();
  read(node, "mark", plot.mark);
  if (const ConfigNode* range = node.find("value_range")) plot.value_range = range->texts();
  if (const ConfigNode* log_value = node.find("log_value")) plot.log_value = log_value->flag();
}

// What is shown of what, and the file that it is called by.
void read_data(const ConfigNode& node, PlotSpec& plot) {
  read(node, "x", plot.x);
  if (plot.x.empty()) plot.kind = PlotKind::bars;
  if (const ConfigNode* kind = node.find("kind")) {
    plot.kind = static_cast<PlotKind>(kind->choice(kKinds));
  }
  const bool is_matrix = plot.kind == PlotKind::matrix;
  const bool is_heat_map = plot.kind == PlotKind::heat_map;
  if (is_heat_map) plot.x = node.at("x").text();
  if (is_matrix) read_matrix(node, plot);
  if (plot.rows.empty()) {
    if (is_heat_map || is_matrix) plot.value = node.at("value").text();
    plot.y = node.at("y").text();
    plot.file = is_heat_map || is_matrix ? plot.value : plot.y;
  }
  read(node, "file", plot.file);
  read(node, "lines_by", plot.lines_by);
  if (plot.file.empty() || plot.file.find_first_of("/\\ ") != std::string::npos) {
    throw InputError(node.place(), in_quotes(plot.file) + " is not a name for a picture",
                     "use letters, digits and '_'");
  }
}

void read_words(const ConfigNode& node, PlotSpec& plot) {
  read(node, "title", plot.title);
  read(node, "x_label", plot.x_label);
  read(node, "y_label", plot.y_label);
  read(node, "value_label", plot.value_label);
  read(node, "thesis", plot.thesis);
}

}  // namespace

PlotSpec plot_of(const ConfigNode& node) {
  PlotSpec plot;
  plot.place = node.place();
  read_data(node, plot);
  read_words(node, plot);
  if (const ConfigNode* variants = node.find("variants")) plot.variants = variants->texts();
  if (const ConfigNode* at = node.find("at")) {
    for (const std::string& path : at->keys()) {
      const ConfigNode& values = at->at(path);
      const bool is_list = values.kind() == ConfigNode::Kind::list;
      Names levels = is_list ? values.texts() : Names{values.text()};
      for (std::string& level : levels) level = with_whole_path(level, values.place());
      plot.at.emplace_back(path, std::move(levels));
    }
  }
  if (const ConfigNode* references = node.find("references")) {
    for (const std::string& name : references->keys()) {
      plot.references.push_back({name, references->at(name).text()});
    }
  }
  if (const ConfigNode* interval = node.find("interval")) {
    plot.is_binomial = interval->choice({"bootstrap", "binomial"}) == 1;
  }
  if (const ConfigNode* log_x = node.find("log_x")) plot.log_x = log_x->flag();
  if (const ConfigNode* log_y = node.find("log_y")) plot.log_y = log_y->flag();
  return plot;
}

std::string plot_text(const PlotSpec& plot) {
  std::vector<std::pair<std::string, std::string>> references;
  for (const PlotReference& reference : plot.references) {
    references.emplace_back(flow_scalar(reference.name), flow_scalar(reference.value));
  }
  std::vector<std::pair<std::string, std::string>> at;
  for (const auto& [path, values] : plot.at) at.emplace_back(path, flow_list(values));
  return flow_map({{"file", flow_scalar(plot.file)},
                   {"title", flow_scalar(plot.title)},
                   {"kind", kKinds[static_cast<std::size_t>(plot.kind)]},
                   {"x", flow_scalar(plot.x)},
                   {"y", flow_scalar(plot.y)},
                   {"value", flow_scalar(plot.value)},
                   {"rows", plot.rows.empty() ? "" : flow_list(plot.rows)},
                   {"mark", flow_scalar(plot.mark)},
                   {"value_range", plot.value_range.empty() ? "" : flow_list(plot.value_range)},
                   {"log_value", plot.log_value ? "true" : ""},
                   {"lines_by", flow_scalar(plot.lines_by)},
                   {"variants", plot.variants.empty() ? "" : flow_list(plot.variants)},
                   {"at", at.empty() ? "" : flow_map(at)},
                   {"references", references.empty() ? "" : flow_map(references)},
                   {"interval", plot.is_binomial ? "binomial" : ""},
                   {"log_x", plot.log_x ? "true" : "false"},
                   {"log_y", plot.log_y ? "true" : "false"},
                   {"x_label", flow_scalar(plot.x_label)},
                   {"y_label", flow_scalar(plot.y_label)},
                   {"value_label", flow_scalar(plot.value_label)},
                   {"thesis", flow_scalar(plot.thesis)}});
}

void check_plot(const PlotSpec& plot, const Results& plan) {
  check_file(plot, plan);
  for (const std::string& variant : plot.variants) {
    check_name(plot, variant, plan.variants, "not compared here");
  }
  check_levels(plot, plan);
  if (plot.kind == PlotKind::heat_map) {
    check_heat_map(plot, plan);
    return;
  }
  if (plot.kind == PlotKind::matrix) {
    check_matrix(plot, plan);
    return;
  }
  if (plot.kind == PlotKind::series) {
    check_series(plot, plan);
    return;
  }
  const Names axes = axes_of(plan);
  const Names metrics = metrics_of(plan);
  Names for_x = axes;
  for_x.insert(for_x.end(), metrics.begin(), metrics.end());
  check_name(plot, plot.y, metrics, "not measured here");
  check_name(plot, plot.x, for_x, "neither measured nor swept here");
  check_name(plot, plot.lines_by, axes, "not swept here");
  if (!plot.lines_by.empty() && plot.lines_by == plot.x) {
    throw InputError(
        plot.place,
        "the plot '" + plot.file + "' has " + in_quotes(plot.x) + " along x and as lines",
        "leave lines_by out");
  }
  check_references(plot, plan.metrics[static_cast<std::size_t>(metric_index(plan, plot.y))].unit);
}

}  // namespace mapbed
