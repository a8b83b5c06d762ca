#pragma once

// Plots as they can stand in a paper, written as SVG: fonts as text, colours of Okabe and Ito, and
// for readers without colours every series with its own dash, marker or hatching. The legend
// stands above the data, never on them.

#include <string>
#include <vector>

#include "bench/plot/axis.h"

namespace mapbed {

enum class Mark {
  line,    // with a marker at each value
  points,  // markers alone
  bars,
  path,  // a thin line without markers: where something went, an outline
  dots,  // small ones: a cloud of many
};

// Values over places. NaN is a gap: the line is broken there. A list of intervals may be empty.
struct PlotSeries {
  std::string name;
  std::vector<double> x;
  std::vector<double> y;          // as many as x
  std::vector<double> low = {};   // the interval about y, as many as x or none
  std::vector<double> high = {};  // of a line a band, else an error bar; NaN: no interval here
  Mark mark = Mark::line;
  int like = -1;  // number of the series whose colour this one has; -1: one of its own
};

// A value from elsewhere that the series are to be seen against.
struct Reference {
  std::string name;  // "thesis"
  double y = 0.0;
};

struct Plot {
  std::string title;     // what is to be seen
  std::string subtitle;  // what was done to the data: "mean of 50 runs, band: 95 % bootstrap"
  Axis x;
  Axis y;
  std::vector<PlotSeries> series;
  std::vector<Reference> references = {};
  bool equal_scales = false;  // as on a map: a metre is as long along y as along x
};

std::string svg_of(const Plot& plot);

// The numbers of the plot: series, x and y with the titles of the axes, low, high. Gaps are empty,
// categories stand by name.
std::string csv_of(const Plot& plot);

}  // namespace mapbed
