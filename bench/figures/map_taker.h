#pragma once

#include <optional>

#include "algorithms/grid/map_builder.h"
#include "bench/plot/map_figure.h"
#include "bench/sources/run_viewer.h"

namespace mapbed {

// Takes the map of a run and what met what moves, and ends the run there.
class MapTaker : public RunViewer {
 public:
  explicit MapTaker(const MapOptions& options) : options_(options) {}

  void begins(const RunInput& prepared, const std::string& method) override;
  void after(const Measurement& /*measurement*/, const Estimator& /*estimator*/) override {}
  void ends(const Estimate& estimate) override;  // throws Interrupted
  bool is_complete() const override { return taken_.has_value(); }

  const NamedMap& taken() const { return *taken_; }  // once it is complete

 private:
  MapOptions options_;
  const RunInput* input_ = nullptr;
  std::optional<NamedMap> taken_;
};

}  // namespace mapbed
