#include "bench/metrics/entropy.h"

#include <cmath>
#include <limits>

namespace mapbed {

double mean_entropy(const OccupancyMap& map) {
  double sum = 0.0;
  int count = 0;
  const auto term = [](double p) { return p > 0.0 ? -p * std::log2(p) : 0.0; };
  map.for_each([&](CellIndex, const Occupancy& cell) {
    if (!cell.known()) return;
    const double p = cell.probability;
    sum += term(p) + term(1.0 - p);
    ++count;
  });
  return count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace mapbed
