#pragma once

#include <optional>
#include <vector>

#include "algorithms/estimator.h"
#include "algorithms/input/odometry_check.h"
#include "algorithms/input/repeated_scans.h"
#include "algorithms/remark.h"
#include "core/config/option.h"
#include "core/log/sensor_log.h"

namespace mapbed {

// How what sensors tell is prepared, the same for every method.
struct InputOptions {
  OdometryCheckOptions odometry;
  RepeatedScanOptions repeated;
};

template <class Visitor>
void visit_fields(InputOptions& o, Visitor&& visit) {
  visit("odometry", o.odometry, "which odometry has jumped");
  visit("repeated", o.repeated, "which scans are no measurement, as they repeat the one before");
}

// What a whole log shows of its sensors, where somebody has it before a method begins.
struct InputFindings {
  std::optional<UsualMotion> usual_motion;
};

InputFindings findings_in(const SensorLog& log, const InputOptions& options);

// Stands in front of a method: takes what sensors tell and gives what a method may believe, one
// scan for each instant, in order of time. What is in order is not changed.
class InputStage {
 public:
  explicit InputStage(const InputOptions& options = {}, const InputFindings& findings = {});

  std::vector<Measurement> add(Measurement measurement);
  std::vector<Remark> remarks() const;  // their words tell times from the first measurement on

 private:
  OdometryCheck odometry_;
  RepeatedScans repeated_;
  std::optional<double> start_;  // [s]
};

struct PreparedLog {
  SensorLog log;
  std::vector<Remark> remarks;
};

// A whole log through the stage, with what it finds in it. Method, map builder and metrics that
// pair poses with scans need the same one.
PreparedLog prepared(SensorLog log, const InputOptions& options = {});

// What the stage said, before the method's own remarks, and behind them what the whole estimate
// shows of the log's odometry.
void add_remarks_on_input(const PreparedLog& prepared, Estimate& estimate);

}  // namespace mapbed
