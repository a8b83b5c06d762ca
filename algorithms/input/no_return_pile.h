#pragma once

#include <map>
#include <vector>

#include "algorithms/remark.h"
#include "core/config/option.h"
#include "core/log/sensor_log.h"

namespace mapbed {

struct NoReturnPileOptions {
  double fraction = 0.02;  // of a laser's readings
};

template <class Visitor>
void visit_fields(NoReturnPileOptions& o, Visitor&& visit) {
  visit("fraction", o.fraction, kFraction,
        "of a laser's readings that lie in a thin pile below its maximum range, at least, before "
        "these are taken as no return; 1: never");
}

// Readings of one laser that lie in a thin pile just below its maximum range: what some drivers
// tell of beams that got no return, with the laser's noise on it.
struct NoReturnPile {
  double from = 0.0;       // [m] the pile begins here
  double max_range = 0.0;  // [m] and ends here
  double fraction = 0.0;   // of the readings
};

// By laser. Surfaces spread their readings over all ranges while a robot moves: a pile is many
// times as high as what lies next to it, in most of the scans.
std::map<int, NoReturnPile> no_return_piles(const SensorLog& log,
                                            const NoReturnPileOptions& options = {});

// The scan with the pile's readings as no return.
LaserScan without_pile(LaserScan scan, const std::map<int, NoReturnPile>& piles);

std::vector<Remark> remarks_on(const std::map<int, NoReturnPile>& piles);

}  // namespace mapbed
