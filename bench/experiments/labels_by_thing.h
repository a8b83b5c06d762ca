#pragma once

#include <string>
#include <vector>

#include "bench/metrics/label_error.h"
#include "bench/results/results.h"
#include "sim/truth/truth.h"

namespace mapbed {

// Of the beams on one kind of thing that does one thing, the fraction called dynamic: who is fooled
// by what. `dynamic_moving_people` and the like.
struct ThingMetric {
  Metric metric;
  EntityKind kind = EntityKind::structure;
  Cause cause = Cause::place;
  std::string name = {};  // of entities of the place: those alone that are called so; empty: all
};

const std::vector<ThingMetric>& metrics_by_thing();

// NaN where there are none.
double fraction_called_dynamic(const LabelErrors& errors, const ThingMetric& of,
                               const TruthHeader& truth);

}  // namespace mapbed
