#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "bench/results/series.h"
#include "core/config/option.h"
#include "core/input_error.h"

namespace mapbed {

// What a scenario has come to: everything that stands in results/<id>/, in memory. runs.csv has a
// line for each RunRow, summary.csv for each SummaryRow, claims.csv for each ClaimResult, cost.csv
// for each CostRow; see results_file.h for the columns.

// Something that is measured in every run.
struct Metric {
  std::string name;        // "translation_error"
  Unit unit = Unit::none;  // of all values in memory and in files: SI and radians
  std::string about;
  // Of a run that could not be finished: a failure counts as one, other values are missing.
  double when_failed = std::numeric_limits<double>::quiet_NaN();
};

// What a sweep varies: one option, by its path.
struct SweepAxis {
  std::string path;                // "robot.odometry.rotation_sigma"
  std::vector<std::string> texts;  // as written: "2 deg"
  std::vector<double> numbers;     // 2 for "2 deg"; empty where one of the texts is no number
  std::string unit;                // "deg"; empty where there is none or they differ
  SourceLocation place = {};       // in the scenario
};

// A level is one combination of the axes' values; its number counts the last axis fastest.
struct Level {
  std::vector<int> choice;  // of each axis, index into SweepAxis::texts
};

struct RunRow {
  int run = 0;      // number of the run: by seed, level, variant, the last one fastest
  int level = 0;    // index into Results::levels
  int variant = 0;  // index into Results::variants
  std::uint64_t seed = 0;
  std::vector<double> values;  // of Results::metrics; NaN: there is none
  std::string failure;         // why it failed; empty: it did not. Failed runs stay in the table
};

// Of one metric over all seeds of a level and variant.
struct SummaryRow {
  int level = 0;
  int variant = 0;
  int metric = 0;   // index into Results::metrics
  int runs = 0;     // all of them, failed or not
  int failed = 0;   // of these
  int missing = 0;  // runs without a value; those below are of the others, NaN where there are none
  double mean = 0.0;
  double low = 0.0;  // 95 % bootstrap interval of the mean
  double high = 0.0;
  double median = 0.0;
  double min = 0.0;
  double max = 0.0;
};

// A sentence about the summary that was checked.
struct ClaimResult {
  std::string claim;  // "failures of filter on at most those of filter off, at every level"
  bool held = false;
  bool judged = true;    // false: the run has no such level, or no value there
  std::string measured;  // the figures: "worst at rotation_sigma = 8 deg: 0.12 against 0.30"
  std::string thesis;    // what the thesis says; empty: nothing
  bool of_cost = false;  // about time, which differs from run to run of the same program
};

// Time and memory, which differ from run to run of the same program.
struct CostRow {
  int run = 0;
  double seconds = 0.0;  // [s] of processor time of the run's own thread, without recording
  double recording_seconds = 0.0;  // [s] the same of the recording; 0: another run made it
  double method_seconds = 0.0;     // [s] of `seconds`, the method alone; 0: not told
  double recorded_seconds = 0.0;   // [s] of the log
  double peak_memory = 0.0;        // [bytes] of the whole program so far
};

// A picture of the summary.
enum class PlotKind : int { lines, bars, points, heat_map };

// A value from elsewhere that a plot is to be seen against.
struct PlotReference {
  std::string name;   // "published"
  std::string value;  // of the plot's metric, with its unit: "0.22 m"
};

struct PlotSpec {
  std::string file;  // figures/<file>.svg
  std::string title;
  PlotKind kind = PlotKind::lines;  // points: one for each run, x is a metric
  std::string x;         // path of an axis, or a metric; empty: the variants side by side
  std::string y;         // a metric; of a heat map the path of an axis
  std::string value;     // of a heat map: the metric that the colours show
  std::string lines_by;  // path of a second axis, a line for each of its values; or empty
  std::vector<std::string> variants;  // empty: all
  // Path of an axis and the values of it that are shown, as written; others are shown whole.
  std::vector<std::pair<std::string, std::vector<std::string>>> at = {};
  std::vector<PlotReference> references = {};
  bool log_x = false;
  bool log_y = false;
  std::string x_label;  // empty: by path and unit
  std::string y_label;
  std::string value_label;    // of a heat map
  std::string thesis;         // which figure it stands beside
  SourceLocation place = {};  // in the scenario
};

struct Results {
  std::string id;      // "ch3_noise_sweep"
  std::string about;   // the question
  std::string thesis;  // "Figure 3.10"
  bool quick = false;  // the reduced run
  std::vector<SweepAxis> axes;
  std::vector<Level> levels;          // one without choice where nothing is swept
  std::vector<std::string> variants;  // one of the name "all" where nothing is compared
  std::vector<Metric> metrics;
  std::vector<SeriesMetric> series_metrics;  // what is measured over time or iterations
  std::vector<PlotSpec> plots;
  std::vector<std::string> skipped;  // what was not run and why; it has no rows
  std::vector<RunRow> runs;          // by number, all of them
  std::vector<Series> series;        // by run, then as in series_metrics; none: the run has none
  std::vector<SummaryRow> summary;
  std::vector<ClaimResult> claims;
  std::vector<CostRow> costs;
};

// "rotation_sigma = 2 deg, people = 3"; "all" for a level without choice.
std::string level_text(const Results& results, int level);

}  // namespace mapbed
