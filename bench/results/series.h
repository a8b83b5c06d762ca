#pragma once

#include <string>
#include <vector>

#include "core/config/option.h"

namespace mapbed {

// A value that a run has not once, as of a metric, but at each of its iterations or over its time.
struct SeriesMetric {
  std::string name;        // "residual"
  Unit unit = Unit::none;  // of the values, in memory and in files: SI and radians
  std::string x_name;      // "iteration", "time"
  Unit x_unit = Unit::none;
  std::string about;
};

struct SeriesPoint {
  double x = 0.0;  // number of the iteration, from 0, or [s] since the start of the log
  double value = 0.0;
};

// Over iterations a run that ended has settled where it was; over time nothing is known then.
inline bool stays_where_it_ends(const SeriesMetric& metric) {
  return metric.x_unit == Unit::none;
}

// Of one run; its units are those of the SeriesMetric of the same name.
struct Series {
  std::string name;
  std::vector<SeriesPoint> points;  // x rising; without gaps: a point without a value is left out
  int run = 0;                      // filled in by who does the runs
};

}  // namespace mapbed
