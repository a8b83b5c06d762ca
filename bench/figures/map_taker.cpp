#include "bench/figures/map_taker.h"

#include "algorithms/estimator.h"
#include "bench/sources/run_input.h"
#include "core/interrupted.h"

namespace mapbed {

void MapTaker::begins(const RunInput& prepared, const std::string& /*method*/) {
  input_ = &prepared;
}

void MapTaker::ends(const Estimate& estimate) {
  const std::span<const ScanLabels> labels = labels_in(estimate);
  taken_.emplace(
      NamedMap{"", build_map(input_->log, estimate.trajectory, options_, labels),
               dynamic_points(input_->log, estimate.trajectory, labels, options_.beams)});
  throw Interrupted();
}

}  // namespace mapbed
