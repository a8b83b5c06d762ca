#pragma once

#include <vector>

#include "algorithms/rfid/strength_fit.h"
#include "bench/experiments/rfid_reads/reads_file.h"

namespace mapbed {

// All reads of one tag at one place by one antenna: their mean strength, and what they have beside
// it.
struct StrengthCell {
  StrengthReading reading;
  int place = 0;         // index into PlacedReads::places
  double reads = 0.0;    // how many
  double squares = 0.0;  // [dB^2] of their differences from the mean, summed

  // Of the reads' differences from any strength.
  double squares_about(double strength) const {
    const double off = reading.strength - strength;
    return squares + reads * off * off;
  }
};

// By antenna, place and tag; `port` is 1 or 2.
std::vector<StrengthCell> strength_cells(const PlacedReads& reads, int port);

// [dB] standard deviation of reads of one tag at one place by one antenna on one carrier.
double noise_of(const PlacedReads& reads, int port);

// [dB] RMS of the cells' readings less what is best said of them by a number for each antenna at
// each place and one for each tag, in sample: no function of the block's place comes below it.
double spread_beside_places(const std::vector<StrengthCell>& cells);

}  // namespace mapbed
