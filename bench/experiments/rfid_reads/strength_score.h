#pragma once

#include <vector>

#include <Eigen/Core>

#include "bench/experiments/rfid_reads/read_means.h"
#include "bench/experiments/rfid_reads/strength_map.h"

namespace mapbed {

struct PlaceSearchOptions {
  double step = 0.1;    // [m]
  double margin = 0.5;  // [m] of the box about all places
};

template <class Visitor>
void visit_fields(PlaceSearchOptions& o, Visitor&& visit) {
  visit("step", o.step, Unit::meter, between(0.02, 2.0), "of the lattice of places");
  visit("margin", o.margin, Unit::meter, between(0.0, 10.0), "of its box about all places");
}

// What was said of places held out, fold by fold.
struct StrengthScore {
  struct Prediction {
    StrengthCell cell;
    double strength = 0.0;  // [dBm] that was predicted
  };
  struct Position {
    Eigen::Vector3d truth, found;
  };
  std::vector<Prediction> predictions;  // each cell once
  std::vector<Position> blocks;         // by all tags of a place together
  std::vector<Position> tags;           // by each tag alone; the truth is the block's
  double log_likelihood = 0.0;          // mean of a read, as a density per dB
  double baseline_squares = 0.0;        // [dB^2] mean of a cell, by antenna_and_tag
  double squares = 0.0;                 // [dB^2] the same by what was asked for
};

// The standard deviations of reads and cells are by the next fold, of what is learned without both.
StrengthScore held_out_score(const std::vector<StrengthCell>& cells, const PlacedReads& reads,
                             const std::vector<int>& folds, const StrengthMapOptions& map,
                             const PlaceSearchOptions& search);

}  // namespace mapbed
