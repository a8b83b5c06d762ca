#include "algorithms/input/input_stage.h"

#include <utility>

#include "algorithms/input/odometry_comparison.h"
#include "algorithms/input/odometry_lag.h"

namespace mapbed {

InputFindings findings_in(const SensorLog& log, const InputOptions&) {
  return {.usual_motion = usual_motion(log)};
}

InputStage::InputStage(const InputOptions& options, const InputFindings& findings)
    : odometry_(options.odometry, findings.usual_motion), repeated_(options.repeated) {}

std::vector<Measurement> InputStage::add(Measurement measurement) {
  if (!start_) start_ = time_of(measurement);
  if (auto* reading = std::get_if<Odometry>(&measurement)) {
    *reading = odometry_.checked(*reading);
    repeated_.add(*reading);
  } else if (auto* scan = std::get_if<LaserScan>(&measurement)) {
    *scan = repeated_.checked(std::move(*scan));
  }
  std::vector<Measurement> result;
  result.push_back(std::move(measurement));
  return result;
}

std::vector<Remark> InputStage::remarks() const {
  std::vector<Remark> result = odometry_.remarks(start_.value_or(0.0));
  for (Remark& remark : repeated_.remarks(start_.value_or(0.0))) {
    result.push_back(std::move(remark));
  }
  return result;
}

PreparedLog prepared(SensorLog log, const InputOptions& options) {
  PreparedLog result;
  const std::optional<double> lag = odometry_lag(log);
  if (lag) log = without_lag(std::move(log), *lag);
  InputStage stage(options, findings_in(log, options));
  result.log.reserve(log.size());
  for (Measurement& measurement : log) {
    for (Measurement& ready : stage.add(std::move(measurement))) {
      result.log.push_back(std::move(ready));
    }
  }
  result.remarks = stage.remarks();
  if (lag) result.remarks.push_back(remark_on_lag(*lag));
  return result;
}

void add_remarks_on_input(const PreparedLog& prepared, Estimate& estimate) {
  estimate.remarks.insert(estimate.remarks.begin(), prepared.remarks.begin(),
                          prepared.remarks.end());
  for (Remark& remark : remarks_on_odometry(prepared.log, estimate.trajectory)) {
    estimate.remarks.push_back(std::move(remark));
  }
}

}  // namespace mapbed
