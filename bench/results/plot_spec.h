#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/config/config_node.h"
#include "core/input_error.h"

namespace mapbed {

struct Results;

// What a plot shows: means of a metric as lines or bars, its single runs as points, means as
// colours, over two axes of numbers or of names, or a series over its iterations or time.
enum class PlotKind : int { lines, bars, points, heat_map, series, matrix };

// A value from elsewhere that a plot is to be seen against.
struct PlotReference {
  std::string name;   // "published"
  std::string value;  // of the plot's metric, with its unit: "0.22 m"
};

// An entry of a scenario's `plots`:
//
//   {file: error, x: robot.odometry.rotation_sigma, y: translation_error, log_y: true,
//    title: Error over noise, variants: [raw, matched], references: {published: 0.22 m}}
//   {y: failures}                                   the variants side by side
//   {kind: points, x: path_length, y: failures}     a mark for each run
//   {kind: heat_map, x: hits, y: misses, value: occupancy, variants: [counting]}
//   {kind: matrix, y: fault, x: log, value: error_ratio, log_value: true, mark: told}
//   {kind: matrix, file: removed, rows: [of_people, of_doors]}   a row for each metric
//   {kind: series, y: residual, log_y: true}        over the iterations of the series
//   {x: noise, y: failures, interval: binomial}     of what is 0 or 1 in each run
//   {y: failures, at: {people: 10}}                 these levels alone; also {people: [5, 10]}
//
// x is an axis or, of points, a metric; y a metric, of a heat map an axis, or a series; lines_by a
// second axis. A matrix has a row for each value of the axis y and a column for each variant, or
// for each variant at each value of the axis x; a dot where the metric `mark` is above 0.5; colours
// end at `value_range: [1, 100]`. Also: x_label, y_label, value_label, log_x, thesis.
struct PlotSpec {
  std::string file;  // figures/<file>.svg
  std::string title;
  PlotKind kind = PlotKind::lines;
  std::string x;          // path of an axis, or a metric; empty: the variants side by side
  std::string y;          // a metric; of a heat map the path of an axis; of a series its name
  std::string value;      // of a heat map or matrix: the metric that the colours show
  std::string mark = {};  // of a matrix: the metric of the dots; or empty
  std::vector<std::string> rows = {};         // of a matrix: metrics, in place of y and value
  std::vector<std::string> value_range = {};  // of a matrix: two numbers with unit, or none
  bool log_value = false;                     // of a matrix
  std::string lines_by;  // path of a second axis, a line for each of its values; or empty
  std::vector<std::string> variants;  // empty: all
  // Path of an axis and the values of it that are shown, as written; others are shown whole.
  std::vector<std::pair<std::string, std::vector<std::string>>> at = {};
  std::vector<PlotReference> references = {};
  bool is_binomial = false;  // intervals: of a metric that is 0 or 1 in each run, Wilson's
  bool log_x = false;
  bool log_y = false;
  std::string x_label;  // empty: by path and unit
  std::string y_label;
  std::string value_label;    // of a heat map
  std::string thesis;         // which figure it stands beside
  SourceLocation place = {};  // in the scenario
};

PlotSpec plot_of(const ConfigNode& node);

// One line, of which plot_of makes the same again.
std::string plot_text(const PlotSpec& plot);

// Throws InputError where a plot names a metric, series, variant, axis or unit that there is not.
void check_plot(const PlotSpec& plot, const Results& plan);

}  // namespace mapbed
