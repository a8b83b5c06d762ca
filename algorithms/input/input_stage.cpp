#include "algorithms/input/input_stage.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "algorithms/input/geometry_check.h"
#include "algorithms/input/odometry_comparison.h"
#include "algorithms/input/odometry_lag.h"
#include "algorithms/input/scan_order.h"
#include "algorithms/input/sweep_correction.h"

namespace mapbed {
namespace {

constexpr double kLongestWait = 1.0;  // [s] for odometry after a sweep

void append(std::vector<Remark> some, std::vector<Remark>& all) {
  std::move(some.begin(), some.end(), std::back_inserter(all));
}

void append(std::vector<Measurement> some, SensorLog& log) {
  std::move(some.begin(), some.end(), std::back_inserter(log));
}

}  // namespace

InputFindings findings_in(const SensorLog& log, const InputOptions& options) {
  const bool finds_period = options.sweep.find_period && options.sweep.beam_period == 0.0;
  return {.usual_motion = usual_motion(log),
          .piles = no_return_piles(log, options.no_return),
          .blocked = blocked_beams(log),
          .periods = finds_period ? found_periods(log) : std::map<int, FoundPeriod>{}};
}

InputStage::InputStage(const InputOptions& options, const InputFindings& findings)
    : options_(options),
      findings_(findings),
      odometry_(options.odometry, findings.usual_motion),
      repeated_(options.repeated) {}

std::vector<Measurement> InputStage::add(Measurement measurement) {
  newest_ = time_of(measurement);
  if (!start_) start_ = newest_;
  if (auto* reading = std::get_if<Odometry>(&measurement)) {
    *reading = odometry_.checked(*reading);
    remember(*reading);
    repeated_.add(*reading);
  } else if (auto* scan = std::get_if<LaserScan>(&measurement)) {
    *scan = checked(std::move(*scan));
  }
  waiting_.push_back(std::move(measurement));
  return ready(false);
}

std::vector<Measurement> InputStage::finish() {
  return ready(true);
}

// Each laser alone.
LaserScan InputStage::checked(LaserScan scan) {
  census_.add(scan);
  scan = repeated_.checked(std::move(scan));
  scan = without_pile(std::move(scan), findings_.piles);
  scan = without_blocked(std::move(scan), findings_.blocked);
  const auto found = findings_.periods.find(scan.laser);
  if (scan.beam_period == 0.0) scan.beam_period = options_.sweep.beam_period;
  if (scan.beam_period == 0.0 && found != findings_.periods.end()) {
    scan.beam_period = found->second.beam_period;
  }
  return scan;
}

void InputStage::remember(const Odometry& reading) {
  constexpr std::size_t kMost = 2000;  // readings: more than wait for a sweep
  if (recent_.size() == kMost) recent_.erase(recent_.begin(), recent_.begin() + kMost / 2);
  if (!recent_.empty() && recent_.back().time == reading.time) recent_.pop_back();
  recent_.push_back({reading.time, reading.odometry_from_robot});
}

// The scans among those that wait that are of one instant with the first one.
std::vector<std::size_t> InputStage::instant() const {
  std::vector<std::size_t> numbers{0};
  const auto& first = std::get<LaserScan>(waiting_.front());
  for (std::size_t i = 1; i < waiting_.size(); ++i) {
    const auto* scan = std::get_if<LaserScan>(&waiting_[i]);
    if (time_of(waiting_[i]) > first.time + options_.fusion.within) break;
    const auto belongs = [&](std::size_t number) {
      return are_of_one_instant(std::get<LaserScan>(waiting_[number]), *scan, options_.fusion);
    };
    if (scan != nullptr && std::all_of(numbers.begin(), numbers.end(), belongs)) {
      numbers.push_back(i);
    }
  }
  return numbers;
}

bool InputStage::is_complete(const std::vector<std::size_t>& instant) const {
  const auto& first = std::get<LaserScan>(waiting_.front());
  if (newest_ <= first.time + options_.fusion.within) return false;
  return std::all_of(instant.begin(), instant.end(), [&](std::size_t number) {
    const auto& scan = std::get<LaserScan>(waiting_[number]);
    const double duration = sweep_duration(scan), end = scan.time + duration;
    return duration == 0.0 || newest_ > end + kLongestWait ||
           (!recent_.empty() && recent_.back().time >= end);
  });
}

// Out of those that wait, but for the first one.
LaserScan InputStage::taken(const std::vector<std::size_t>& instant) {
  std::vector<LaserScan> scans;
  for (const std::size_t number : instant) {
    auto& scan = std::get<LaserScan>(waiting_[number]);
    scans.push_back(with_corrected_sweep(std::move(scan), recent_));
  }
  for (std::size_t i = instant.size(); i-- > 1;) {
    waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(instant[i]));
  }
  return fused(std::move(scans), recent_);
}

std::vector<Measurement> InputStage::ready(bool is_over) {
  std::vector<Measurement> result;
  while (!waiting_.empty()) {
    if (std::holds_alternative<LaserScan>(waiting_.front())) {
      const std::vector<std::size_t> instant = this->instant();
      if (!is_over && !is_complete(instant)) break;
      LaserScan scan = taken(instant);
      append(odometry_at_scans_.add(std::move(scan)), result);
    } else {
      append(odometry_at_scans_.add(std::move(waiting_.front())), result);
    }
    waiting_.pop_front();
  }
  if (is_over) append(odometry_at_scans_.finish(), result);
  return result;
}

std::vector<Remark> InputStage::remarks() const {
  const double start = start_.value_or(0.0);
  std::vector<Remark> result = odometry_.remarks(start);
  append(repeated_.remarks(start), result);
  append(remarks_on(findings_.piles), result);
  append(remarks_on(findings_.blocked), result);
  append(remarks_on(findings_.periods), result);
  append(census_.remarks(), result);
  return result;
}

PreparedLog prepared(SensorLog log, const InputOptions& options) {
  PreparedLog result;
  const std::vector<Remark> of_geometry = remarks_on_geometry(log);
  const std::vector<SwappedScans> swapped = swapped_scans(log);
  log = in_order(std::move(log), swapped);
  const double start = log.empty() ? 0.0 : time_of(log.front());
  const InputFindings findings = findings_in(log, options);
  // In the mean, beams are taken half a sweep after the stamp: as if odometry were early or late.
  std::optional<double> lag;
  if (findings.periods.empty()) lag = odometry_lag(log);
  if (lag.has_value()) log = without_lag(std::move(log), lag.value());
  InputStage stage(options, findings);
  result.log.reserve(log.size());
  for (Measurement& measurement : log) append(stage.add(std::move(measurement)), result.log);
  append(stage.finish(), result.log);
  result.remarks = of_geometry;
  append(remarks_on(swapped, start), result.remarks);
  append(stage.remarks(), result.remarks);
  if (lag.has_value()) result.remarks.push_back(remark_on_lag(lag.value()));
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
