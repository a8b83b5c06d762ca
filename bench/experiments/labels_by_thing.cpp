#include "bench/experiments/labels_by_thing.h"

#include <limits>

namespace mapbed {
namespace {

constexpr const char* kColumn = "column";

std::vector<ThingMetric> table() {
  struct Kind {
    EntityKind kind;
    const char* name;
  };
  struct Does {
    Cause cause;
    const char* name;
    const char* about;
  };
  std::vector<ThingMetric> rows;
  for (const Kind& kind : {Kind{EntityKind::person, "people"}, Kind{EntityKind::door, "doors"},
                           Kind{EntityKind::movable, "movables"}}) {
    for (const Does& does : {Does{Cause::moving, "moving", "that move just then"},
                             Does{Cause::waiting, "waiting", "that move at another time"},
                             Does{Cause::resting, "resting", "that could move and never do"}}) {
      rows.push_back({{std::string("dynamic_") + does.name + "_" + kind.name, Unit::none,
                       std::string("of beams on ") + kind.name + " " + does.about +
                           ", the fraction called dynamic"},
                      kind.kind,
                      does.cause});
    }
  }
  rows.push_back({{"dynamic_columns", Unit::none,
                   "of beams on things of the place that are named column, the fraction called "
                   "dynamic"},
                  EntityKind::structure,
                  Cause::place,
                  kColumn});
  return rows;
}

}  // namespace

const std::vector<ThingMetric>& metrics_by_thing() {
  static const std::vector<ThingMetric> rows = table();
  return rows;
}

double fraction_called_dynamic(const LabelErrors& errors, const ThingMetric& of,
                               const TruthHeader& truth) {
  if (of.name.empty()) {
    const auto found = errors.by_kind.find({of.kind, of.cause});
    return found == errors.by_kind.end() ? std::numeric_limits<double>::quiet_NaN()
                                         : found->second.fraction();
  }
  LabelCounts sum;
  for (const auto& [entity, counts] : errors.of_place) {
    if (truth.entities[static_cast<std::size_t>(entity)].name != of.name) continue;
    sum.beams += counts.beams;
    sum.dynamic += counts.dynamic;
  }
  return sum.fraction();
}

}  // namespace mapbed
