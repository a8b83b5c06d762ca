#pragma once

#include <limits>
#include <string>
#include <vector>

#include "bench/plot/plot.h"
#include "bench/results/results.h"

// What the figures of results have in common: which runs they show, what their lines and axes are
// called, what is said below the title.

namespace mapbed {

inline constexpr int kVariantsAlongX = -2;  // in place of an axis' index

Axis metric_axis(const std::string& name, Unit unit, const std::string& label, bool logarithmic);
Axis swept_axis(const SweepAxis& axis, const std::string& label, bool logarithmic);

// Whether the plot shows a variant, or runs of that level and variant.
bool is_shown(const Results& results, const PlotSpec& spec, int variant);
bool is_shown(const Results& results, const PlotSpec& spec, int level, int variant);

// What makes one line: the variant and the values of all axes but that along x and those of which
// one value is shown.
std::string line_name(const Results& results, const PlotSpec& spec, int level, int variant,
                      int x_axis);

// The line of that name, which is added where there is none.
PlotSeries& line_of(Plot& plot, const std::string& name, Mark mark);

// The runs behind a picture of the summary.
struct ShownRuns {
  int runs = 0, failed = 0, missing = 0;
  int least = std::numeric_limits<int>::max(), most = 0;  // of one place

  void add(const SummaryRow& row);
  // `several` with the number, "10" or "8 to 10", in place of its braces.
  std::string runs_each(const std::string& several) const;
};

// The subtitle: what was done to the data, and what is not to be seen in them.
std::string subtitle_of(const PlotSpec& spec, const std::string& treatment, const ShownRuns& shown);

}  // namespace mapbed
