#pragma once

#include <deque>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "algorithms/estimator.h"
#include "algorithms/input/beam_census.h"
#include "algorithms/input/blocked_beams.h"
#include "algorithms/input/no_return_pile.h"
#include "algorithms/input/odometry_at_scans.h"
#include "algorithms/input/odometry_check.h"
#include "algorithms/input/repeated_scans.h"
#include "algorithms/input/scan_fusion.h"
#include "algorithms/input/sweep_period.h"
#include "algorithms/remark.h"
#include "core/config/option.h"
#include "core/geometry/trajectory.h"
#include "core/log/sensor_log.h"

namespace mapbed {

// How what sensors tell is prepared, the same for every method.
struct InputOptions {
  OdometryCheckOptions odometry;
  RepeatedScanOptions repeated;
  NoReturnPileOptions no_return;
  SweepOptions sweep;
  ScanFusionOptions fusion;
};

template <class Visitor>
void visit_fields(InputOptions& o, Visitor&& visit) {
  visit("odometry", o.odometry, "which odometry has jumped");
  visit("repeated", o.repeated, "which scans are no measurement, as they repeat the one before");
  visit("no_return", o.no_return, "which readings just below the maximum range are no return");
  visit("sweep", o.sweep, "beams that are taken one after the other");
  visit("fusion", o.fusion, "scans of several lasers at one instant");
}

// What a whole log shows of its sensors, where somebody has it before a method begins.
struct InputFindings {
  std::optional<UsualMotion> usual_motion;
  std::map<int, NoReturnPile> piles;    // by laser
  std::map<int, BlockedBeams> blocked;  // by laser
  std::map<int, FoundPeriod> periods;   // by laser
};

InputFindings findings_in(const SensorLog& log, const InputOptions& options);

// Stands in front of a method: takes what sensors tell and gives what a method may believe, one
// scan for each instant, in order of time. What is in order is not changed. A scan is held back
// until its instant is over, and until odometry tells where it and its last beam were taken.
class InputStage {
 public:
  explicit InputStage(const InputOptions& options = {}, const InputFindings& findings = {});

  std::vector<Measurement> add(Measurement measurement);  // what is ready with it
  std::vector<Measurement> finish();                      // the rest
  std::vector<Remark> remarks() const;  // their words tell times from the first measurement on

 private:
  LaserScan checked(LaserScan scan);
  std::vector<Measurement> ready(bool is_over);
  std::vector<std::size_t> instant() const;
  bool is_complete(const std::vector<std::size_t>& instant) const;
  LaserScan taken(const std::vector<std::size_t>& instant);
  void remember(const Odometry& reading);

  InputOptions options_;
  InputFindings findings_;
  OdometryCheck odometry_;
  RepeatedScans repeated_;
  BeamCensus census_;
  std::optional<double> start_;                               // [s]
  double newest_ = -std::numeric_limits<double>::infinity();  // [s]
  std::deque<Measurement> waiting_;                           // in order of time
  Trajectory recent_;                                         // odometry_from_robot
  OdometryAtScans odometry_at_scans_;
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
