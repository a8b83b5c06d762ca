#include "bench/experiments/end_points.h"

#include <cmath>

#include "algorithms/grid/map_builder.h"
#include "bench/experiments/posed_scans.h"
#include "bench/plot/map_picture.h"
#include "core/image/png.h"

namespace mapbed {
namespace {

struct EndPointsOptions {
  int scans = 0;
  MapOptions map;
};

template <class Visitor>
void visit_fields(EndPointsOptions& o, Visitor&& visit) {
  visit("scans", o.scans, between(0, 10'000'000), "the first of the log that are used; 0: all");
  visit("map", o.map, "how the maps are made; model is not looked at");
}

// Two maps of the same scans.
struct Difference {
  int cells = 0;       // that are known to both
  double mean = 0.0;   // of |a - b|
  double agree = 0.0;  // fraction of cells on the same side of 0.5
};

Difference difference_of(const OccupancyMap& a, const OccupancyMap& b) {
  Difference result;
  double sum = 0.0;
  int agree = 0;
  a.for_each([&](CellIndex cell, const Occupancy& of_a) {
    const Occupancy& of_b = b[cell];
    if (!of_a.known() || !of_b.known()) return;
    ++result.cells;
    sum += std::abs(of_a.probability - of_b.probability);
    agree += (of_a.probability >= 0.5F) == (of_b.probability >= 0.5F) ? 1 : 0;
  });
  result.mean = sum / result.cells;
  result.agree = static_cast<double>(agree) / result.cells;
  return result;
}

RunOutcome run(const EndPointsOptions& options, const RunInput& input) {
  const PosedScans posed = posed_scans(input, options.scans);
  const auto map_by = [&](MapModel model) {
    MapOptions map = options.map;
    map.model = model;
    return build_map(posed.scans, posed.world_from_robot, map);
  };
  const OccupancyMap odds = map_by(MapModel::end_points_odds);
  const OccupancyMap counting = map_by(MapModel::end_points_counting);
  const Difference ends = difference_of(odds, counting);
  const Difference full = difference_of(map_by(MapModel::odds), map_by(MapModel::counting));
  RunOutcome outcome;
  outcome.values = {{"hit_cells", ends.cells},
                    {"end_point_difference", ends.mean},
                    {"end_point_agreement", ends.agree},
                    {"full_difference", full.mean},
                    {"full_agreement", full.agree}};
  const auto show = [&](const std::string& name, const OccupancyMap& map) {
    const std::string png = png_of(picture_of(map, {}, {.longest_side = 1000}));
    outcome.files.push_back({"maps/" + name + ".png", png});
  };
  if (input.shown && ends.cells > 0) {
    show("end_points_odds", odds);
    show("end_points_counting", counting);
  }
  return outcome;
}

}  // namespace

Experiment end_points_experiment() {
  return make_experiment<EndPointsOptions>(
      "end_points", "end points alone by the odds and by the counting model, Figure 2.10",
      Experiment::Needs::truth,
      {{"hit_cells", Unit::none, "cells in which a beam ended"},
       {"end_point_difference", Unit::none, "mean difference of the two models in these cells"},
       {"end_point_agreement", Unit::none, "fraction of these cells on the same side of 0.5"},
       {"full_difference", Unit::none, "the same of the models with free space, in known cells"},
       {"full_agreement", Unit::none, "fraction of the known cells on the same side of 0.5"}},
      run);
}

}  // namespace mapbed
