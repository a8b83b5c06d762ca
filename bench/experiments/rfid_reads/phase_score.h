#pragma once

#include <vector>

#include "bench/experiments/rfid_reads/phase_cells.h"

namespace mapbed {

// What a channel's phases grow with.
enum class PhaseWay : int { nothing, there_and_back, backwards };

// Of reads at places held out, whose channels' offsets are learned at the others.
struct PhaseScore {
  double gain = 0.0;                // mean log-likelihood of a read over that of a uniform phase
  double agreement = 0.0;           // mean cosine of a read
  double training_agreement = 0.0;  // the same at the places learned from
  double kappa = 0.0;               // mean of the folds
  double tag_shift = 0.0;           // [m] mean of what was found
  double repeated = 0.0;            // [m] median between two folds' answers for the same tag
};

// For PhaseWay::backwards the cells' phases have the other sign already.
PhaseScore held_out_score(const std::vector<PhaseCell>& cells, int antennas, int tags,
                          const std::vector<int>& folds, const PhaseShiftOptions& shifts,
                          PhaseWay way, int turns);

// Mean cosine between the phases of one channel at places 1 m apart, less the way.
double neighbours_agree(const std::vector<PhaseCell>& cells, PhaseWay way, int turns);

// Gain of a read whose cell's mean is known: what no model of places can surpass with one kappa.
double ceiling_of(const std::vector<PhaseCell>& cells);

}  // namespace mapbed
