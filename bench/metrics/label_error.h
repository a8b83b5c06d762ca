#pragma once

#include <map>
#include <utility>

#include "bench/metrics/true_causes.h"
#include "core/labels/beam_labels.h"

namespace mapbed {

struct LabelCounts {
  long beams = 0;           // that have a label
  long dynamic = 0;         // of these, by their labels
  double fraction() const;  // NaN where there are no beams
};

// Labels of beams against what truly made their readings. What could move and never does is right
// either way, and stands apart.
struct LabelErrors {
  LabelCounts place;
  LabelCounts moving;
  LabelCounts waiting;
  LabelCounts resting;
  // The same by what was met and what it did; and of the place by its things alone.
  std::map<std::pair<EntityKind, Cause>, LabelCounts> by_kind;
  std::map<int, LabelCounts> of_place;  // by entity

  LabelCounts of_movers(EntityKind kind) const;  // moving and waiting

  double precision() const;  // of the beams called dynamic, the fraction that met a mover
  double recall() const;     // of the beams that met a mover, the fraction called dynamic
  // As in Jia et al., "A dynamic points removal benchmark in point cloud maps", 2023: fractions of
  // static and of dynamic beams that are labelled right, and the geometric mean of both.
  double static_accuracy() const;
  double dynamic_accuracy() const { return recall(); }
  double associated_accuracy() const;
};

// `log` has the labelled scans, by the same stamps and in the same order.
LabelErrors label_errors(const BeamLabels& labels, const SensorLog& log, const TrueCauses& causes);

}  // namespace mapbed
