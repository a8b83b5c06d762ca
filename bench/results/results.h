#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "bench/results/claim.h"
#include "bench/results/plot_spec.h"
#include "bench/results/series.h"
#include "bench/results/sweep.h"
#include "core/config/option.h"

namespace mapbed {

// Something that is measured in every run.
struct Metric {
  std::string name;        // "translation_error"
  Unit unit = Unit::none;  // of all values in memory and in files: SI and radians
  std::string about;
  // Of a run that could not be finished: a failure counts as one, other values are missing.
  double when_failed = std::numeric_limits<double>::quiet_NaN();
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

// Time and memory, which differ from run to run of the same program.
struct CostRow {
  int run = 0;
  // [s] of processor time of the run's own thread and of programs that are its method, without
  // recording
  double seconds = 0.0;
  double recording_seconds = 0.0;    // [s] the same of the recording; 0: another run made it
  double method_seconds = 0.0;       // [s] of `seconds`, the method alone; 0: not told
  double recorded_seconds = 0.0;     // [s] of the log
  double peak_memory = 0.0;          // [bytes] of the whole program so far
  double method_wall_seconds = 0.0;  // [s] of the method by the clock; 0: not told
  double program_memory = 0.0;       // [bytes] of a program that is the method; 0: there is none
};

// A file of a single run, below the result's folder.
struct FileOfRun {
  std::string path;  // "maps/map_level_2_raw.png"
  int run = 0;
  std::string title;  // what it shows, without the run: "map"; empty: nothing to be told
};

// What a scenario has come to: all that stands in results/<id>/, but for what is in the pictures.
// result_folder.h reads and writes it.
struct Results {
  // What was planned: the part `scenario` of config.yaml.
  std::string id;      // "ch3_noise_sweep"
  std::string about;   // the question
  std::string thesis;  // "Figure 3.10"
  std::string experiment;
  bool quick = false;      // the reduced run
  bool judges = true;      // false: a quick run that is too small to judge claims by
  std::uint64_t seed = 1;  // the first one
  int seeds = 1;
  std::vector<SweepAxis> axes;
  std::vector<Level> levels;          // one without choice where nothing is swept
  std::vector<std::string> variants;  // one of the name "all" where nothing is compared
  std::vector<Metric> metrics;
  std::vector<SeriesMetric> series_metrics;
  std::vector<PlotSpec> plots;
  std::vector<Claim> claims;
  std::vector<std::string> skipped;  // what was not run and why; it has no rows

  // What came of it, a file each.
  std::vector<RunRow> runs;  // by number, all of them
  std::vector<SummaryRow> summary;
  std::vector<Series> series;  // by run
  std::vector<Verdict> verdicts;
  std::vector<CostRow> costs;
  std::vector<FileOfRun> files;  // by run
  std::string config_yaml;       // the whole file
  std::string provenance_json;   // what the results were made with
};

// Index into what has that name or path; -1: there is none.
int metric_index(const Results& results, const std::string& name);
int series_index(const Results& results, const std::string& name);
int variant_index(const Results& results, const std::string& name);
int axis_index(const Results& results, const std::string& path);

// "rotation_sigma = 2 deg, people = 3"; "all" for a level without choice.
std::string level_text(const Results& results, int level);

// Level and variant of a run as people read them, as far as there are others: "people 3, raw".
std::string run_words(const Results& results, const RunRow& run);

}  // namespace mapbed
