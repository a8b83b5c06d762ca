#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algorithms/estimator.h"
#include "bench/results/replay.h"
#include "bench/sources/run_viewer.h"
#include "core/geometry/trajectory.h"
#include "core/log/sensor_log.h"

namespace mapbed {

// What figures of a run are made of.
struct FigureLog {
  SensorLog log;                    // as methods get it
  Trajectory truth;                 // world_from_robot; empty: nobody knows
  std::vector<ReplayTrack> people;  // where they truly were, in the world; empty: nobody knows
};

FigureLog figure_log_of(const RunInput& prepared);

// Takes the log of a run, and ends it there.
class LogTaker : public RunViewer {
 public:
  void begins(const RunInput& prepared, const std::string& method) override;  // throws Interrupted
  void after(const Measurement& /*measurement*/, const Estimator& /*estimator*/) override {}
  void ends(const Estimate& /*estimate*/) override {}
  bool is_complete() const override { return taken_.has_value(); }

  const FigureLog& taken() const { return *taken_; }  // once it is complete

 private:
  std::optional<FigureLog> taken_;
};

}  // namespace mapbed
