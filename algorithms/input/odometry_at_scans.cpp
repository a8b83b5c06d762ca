#include "algorithms/input/odometry_at_scans.h"

#include <iterator>
#include <utility>

namespace mapbed {
namespace {

Odometry between(const Odometry& before, const Odometry& after, double time) {
  const double fraction = (time - before.time) / (after.time - before.time);
  Odometry result = before;
  result.time = time;
  result.odometry_from_robot =
      interpolate(before.odometry_from_robot, after.odometry_from_robot, fraction);
  return result;
}

}  // namespace

std::vector<Measurement> OdometryAtScans::add(Measurement measurement) {
  if (const auto* reading = std::get_if<Odometry>(&measurement)) return released_by(*reading);
  const double time = time_of(measurement);
  std::vector<Measurement> out;
  if (!waiting_.empty() && time - time_of(waiting_.front()) > kLongest) {
    out = finish();
    is_out_ = true;
  }
  const bool waits = before_ && before_->time < time && !is_out_;
  (waits ? waiting_ : out).push_back(std::move(measurement));
  return out;
}

// The scans that waited for this reading, and the reading.
std::vector<Measurement> OdometryAtScans::released_by(const Odometry& reading) {
  const bool bridges = before_ && !is_out_ && !reading.motion_unknown;
  std::vector<Measurement> before, after;
  for (Measurement& scan : finish()) {
    const double time = time_of(scan);
    const bool is_scan = std::holds_alternative<LaserScan>(scan);
    if (is_scan && bridges && time < reading.time)
      before.emplace_back(between(*before_, reading, time));
    (time < reading.time ? before : after).push_back(std::move(scan));
  }
  before_ = reading;
  is_out_ = false;
  before.emplace_back(reading);
  before.insert(before.end(), std::make_move_iterator(after.begin()),
                std::make_move_iterator(after.end()));
  return before;
}

std::vector<Measurement> OdometryAtScans::finish() {
  return std::exchange(waiting_, {});
}

}  // namespace mapbed
