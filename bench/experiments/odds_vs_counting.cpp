#include "bench/experiments/odds_vs_counting.h"

#include "algorithms/grid/counting_map.h"
#include "algorithms/grid/odds_model.h"

namespace mapbed {
namespace {

enum class CellModel : int { counting, odds };

struct OddsVsCountingOptions {
  CellModel model = CellModel::counting;
  int hits = 0;
  int misses = 0;
  OddsModel odds;
};

template <class Visitor>
void visit_fields(OddsVsCountingOptions& o, Visitor&& visit) {
  visit("model", o.model, {"counting", "odds"}, "which of them gives the occupancy");
  visit("hits", o.hits, between(0, 1'000'000), "beams that ended in the cell");
  visit("misses", o.misses, between(0, 1'000'000), "beams that went through it");
  visit("odds", o.odds, "one look at a cell");
}

std::optional<double> occupancy(const OddsVsCountingOptions& o, double hits, double misses) {
  if (o.model == CellModel::counting) return counting_occupancy(hits, misses);
  return odds_occupancy(hits, misses, o.odds);
}

RunOutcome run(const OddsVsCountingOptions& options, const RunInput& /*input*/) {
  check(options.odds);
  RunOutcome outcome;
  const auto value = occupancy(options, options.hits, options.misses);
  if (value) outcome.values.emplace_back("occupancy", *value);
  outcome.values.emplace_back("occupancy_70_of_100", *occupancy(options, 70.0, 30.0));
  return outcome;
}

}  // namespace

Experiment odds_vs_counting_experiment() {
  return make_experiment<OddsVsCountingOptions>(
      "odds_vs_counting", "one cell by the two models, Figures 2.6 and 2.7",
      Experiment::Needs::nothing,
      {{"occupancy", Unit::none, "of the cell; none where the model says unknown"},
       {"occupancy_70_of_100", Unit::none, "of a cell that 70 of 100 beams hit"}},
      run);
}

}  // namespace mapbed
