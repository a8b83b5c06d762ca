#pragma once

#include <vector>

#include "algorithms/rfid/phase_model.h"
#include "bench/experiments/rfid_reads/reads_file.h"
#include "core/config/option.h"

namespace mapbed {

// All reads of one tag at one place by one antenna on one carrier.
struct PhaseCell {
  PhaseReading reading;
  int place = 0;  // index into PlacedReads::places
  int antenna = 0;
  int tag = 0;
};

// By antenna, carrier, tag and place; reads whose carrier is not told are left out. `port` is 1 or
// 2, `turns` the m of PhaseReading.
std::vector<PhaseCell> phase_cells(const PlacedReads& reads, int port, int turns);

// [m] by which tags lie beside the middle of their block, and antennas beside the origin.
struct PhaseShifts {
  std::vector<Eigen::Vector3d> tags, antennas;

  Eigen::Vector3d of(const PhaseCell& cell) const {
    return tags[static_cast<std::size_t>(cell.tag)] -
           antennas[static_cast<std::size_t>(cell.antenna)];
  }
};

struct PhaseShiftOptions {
  bool tags = false;      // are looked for
  bool antennas = false;  // the same
  double reach = 0.25;    // [m] along each axis
  int rounds = 1;         // where both are looked for, by turns
};

template <class Visitor>
void visit_fields(PhaseShiftOptions& o, Visitor&& visit) {
  visit("tags", o.tags, "where each tag is on the block is looked for");
  visit("antennas", o.antennas, "where each antenna is about the origin is looked for");
  visit("reach", o.reach, Unit::meter, between(0.01, 1.0), "along each axis");
  visit("rounds", o.rounds, between(1, 20), "where both are looked for, by turns");
}

// With which the cells agree best within their channels.
PhaseShifts fitted_shifts(const std::vector<PhaseCell>& cells, int antennas, int tags,
                          const PhaseShiftOptions& options, int turns);

}  // namespace mapbed
