#include "core/log/log_builder.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "core/check.h"
#include "core/file/tokens.h"
#include "core/geometry/angle.h"
#include "core/log/bearings.h"
#include "core/log/laser_geometry.h"

namespace mapbed {
namespace {

constexpr double kLatestTime = 1e12;  // [s]

// [bytes] With room for a list that grows, and for a second copy of the ranges.
constexpr std::size_t kMeasurementMemory = 2 * sizeof(Measurement);
constexpr std::size_t kRangeMemory = 2 * sizeof(double);
constexpr std::size_t kParameterMemory = 150;

// The unit in which a number of this size is a stamp of 2001 to 2286; empty: none.
std::string unit_of_stamp(double stamp) {
  if (stamp >= 1e12 && stamp < 1e13) return "milliseconds";
  if (stamp >= 1e15 && stamp < 1e16) return "microseconds";
  if (stamp >= 1e18 && stamp < 1e19) return "nanoseconds";
  return {};
}

void check_options(const LogOptions& o) {
  const auto refuse = [](const std::string& name, const std::string& what) {
    throw InputError({}, "log option " + name + " " + what);
  };
  if (o.first_bearing.size() > 1) refuse("first_bearing", "takes one number or none");
  for (const auto* mount : {&o.robot_from_laser, &o.robot_from_rear_laser})
    if (!mount->empty() && mount->size() != 3)
      refuse(mount == &o.robot_from_laser ? "robot_from_laser" : "robot_from_rear_laser",
             "takes three numbers, x, y, theta, or none");
  if (!(o.field_of_view >= 0.0 && o.field_of_view <= 2.0 * kPi + 1e-9))
    refuse("field_of_view", "must be from 0 to 360 deg");
  if (!(o.max_range >= 0.0)) refuse("max_range", "must not be negative");
  if (!(o.reorder_within >= 0.0)) refuse("reorder_within", "must not be negative");
  if (!(o.scan_period > 0.0)) refuse("scan_period", "must be positive");
  if (!(o.wheels.wheel_radius > 0.0 && o.wheels.half_track > 0.0 && o.wheels.ticks_per_turn > 0.0))
    refuse("wheels", "must have a positive radius, track and number of ticks");
}

bool earlier(const Measurement& a, const Measurement& b) {
  return time_of(a) < time_of(b);
}

// All scans at one time: the stamps were lost.
bool stamps_are_lost(const SensorLog& log) {
  double first = NAN;
  int scans = 0;
  for (const Measurement& m : log) {
    if (!std::holds_alternative<LaserScan>(m)) continue;
    if (scans++ == 0) first = time_of(m);
    if (time_of(m) != first) return false;
  }
  return scans > 1;
}

// Scan k at k periods; what stands between two scans in the file belongs to the later one.
void make_up_stamps(SensorLog& log, double period) {
  double time = 0.0;
  for (Measurement& m : log) {
    std::visit([&](auto& measurement) { measurement.time = time; }, m);
    if (std::holds_alternative<LaserScan>(m)) time += period;
  }
}

bool reads_maximum_range(const RecordedLog& log, int laser) {
  return std::any_of(log.measurements.begin(), log.measurements.end(), [&](const Measurement& m) {
    const auto* scan = std::get_if<LaserScan>(&m);
    if (scan == nullptr || scan->laser != laser) return false;
    return std::any_of(scan->ranges.begin(), scan->ranges.end(),
                       [&](double r) { return r >= scan->max_range; });
  });
}

}  // namespace

LogBuilder::LogBuilder(std::string name, const LogOptions& options, Place counted)
    : name_(std::move(name)), options_(options), counted_(counted) {
  check_options(options);
}

SourceLocation LogBuilder::place(long line) const {
  if (line == 0 || counted_ == Place::line) return {name_, line};
  return {fmt::format("{}, message {}", name_, line)};
}

void LogBuilder::warn(long line, const std::string& reason, const std::string& example) {
  const auto [found, is_new] = warning_of_reason_.try_emplace(reason, log_.warnings.size());
  if (is_new)
    log_.warnings.push_back({place(line), reason + example, 1});
  else
    ++log_.warnings[found->second].count;
}

void LogBuilder::leave_out(long line, const std::string& reason, const std::string& example) {
  if (broken_++ == 0) first_broken_ = {place(line), reason + example, 1};
  warn(line, reason, example);
}

void LogBuilder::broken(long line, const std::string& reason, const std::string& example) {
  ++messages_;
  leave_out(line, reason, example);
}

void LogBuilder::garbled(long line, const std::string& kind, const Tokens& tokens) {
  std::string_view word = tokens.wrong();
  double number = 0.0;
  if (parse_number(word, number)) word = {};  // of which there are too few or too many
  const bool has_comma =
      word.find(',') != word.npos && word.find_first_not_of("0123456789,+-eE") == word.npos;
  if (has_comma && broken_ == 0) remedy_ = "write decimals with a point";
  const std::string example =
      word.empty() ? "" : in_quotes(word) + (has_comma ? " has a decimal comma" : " is no number");
  broken(line, "truncated or garbled " + kind + ": left out",
         example.empty() ? "" : ", " + example);
}

// What is kept must fit into memory, however little text says it.
void LogBuilder::account(std::size_t bytes, long line) {
  memory_ += static_cast<double>(bytes);
  if (memory_ > options_.max_text)
    throw InputError(place(line),
                     fmt::format("the measurements up to here take more than {:.0f} MB",
                                 options_.max_text / 1e6),
                     "raise log.max_text if the file is to be trusted");
}

bool LogBuilder::stamp_is_usable(double time, long line) {
  ++messages_;
  if (!std::isfinite(time) || std::abs(time) > kLatestTime) {
    const std::string unit = unit_of_stamp(time);
    if (broken_ == 0 && !unit.empty()) remedy_ = "write stamps in seconds";
    leave_out(line, "time stamp that is not a time: line left out",
              unit.empty() ? "" : fmt::format(", {:.0f} looks like {}", time, unit));
    return false;
  }
  if (newest_ - time > options_.reorder_within) {
    // One such line alone is a damaged stamp; a second one in a row, and the clock was set back.
    if (line_gone_back_ != 0 && line_gone_back_ != line)
      throw InputError(place(line_gone_back_),
                       fmt::format("the time goes back by {:.3f} s, from {:.6f} to {:.6f}",
                                   newest_ - time, newest_, time),
                       "cut the log there, use the other stamp (stamp) or raise reorder_within");
    if (line_gone_back_ != line)
      warn(line, "time stamp far older than those around it: message left out");
    line_gone_back_ = line;
    return false;
  }
  line_gone_back_ = 0;
  if (time < newest_) {
    warn(line, "time stamp older than one before it: put in order");
    out_of_order_ = true;
  }
  newest_ = std::max(newest_, time);
  return true;
}

void LogBuilder::clean_ranges(LaserScan& scan, long line) {
  Readings& readings = readings_of_laser_[scan.laser];
  for (double& r : scan.ranges) {
    ++readings.all;
    if (r == 0.0) {
      ++readings.zeros;
      if (options_.zero == ZeroReading::no_return) r = INFINITY;
      continue;
    }
    if (r > 0.0 && r <= kAbsurdRange) continue;
    if (r == INFINITY) continue;  // "nothing was hit", as some drivers write it
    if (r != kNoReading)
      warn(line, "absurd range (negative, not a number or above 1 km): beam ignored");
    r = 0.0;
  }
}

// A laser that reads 0 often, and never its maximum range, may mean that nothing came back.
void LogBuilder::look_at_zeros() {
  for (const auto& [laser, readings] : readings_of_laser_) {
    if (10 * readings.zeros <= readings.all || reads_maximum_range(log_, laser)) continue;
    warn(0, fmt::format(
                "{}: {:.0f} % of its readings are 0, and none is its maximum range: they "
                "count as failed; zero: no_return, if they say that nothing was hit",
                name_of_laser(laser),
                100.0 * static_cast<double>(readings.zeros) / static_cast<double>(readings.all)));
  }
}

void LogBuilder::add(Odometry odometry, long line) {
  if (!stamp_is_usable(odometry.time, line)) return;
  const Pose2& pose = odometry.odometry_from_robot;
  if (!is_finite(pose) || std::abs(pose.x) > 1e7 || std::abs(pose.y) > 1e7) {
    leave_out(line, "odometry that is not a pose: left out");
    return;
  }
  odometry.odometry_from_robot.theta = normalized_angle(pose.theta);
  account(kMeasurementMemory, line);
  log_.measurements.emplace_back(odometry);
}

void LogBuilder::add(LaserScan scan, long line) {
  if (!stamp_is_usable(scan.time, line)) return;
  if (scan.ranges.empty()) {
    leave_out(line, "scan without beams: left out");
    return;
  }
  clean_ranges(scan, line);
  const auto [last, is_first] = last_scan_of_laser_.try_emplace(scan.laser);
  if (!is_first && last->second.time == scan.time) warn(line, "same time stamp as the scan before");
  if (!is_first && last->second.beams != scan.ranges.size())
    warn(line, "number of beams differs from the scan before");
  last->second = {scan.time, scan.ranges.size()};
  first_line_of_beams_.try_emplace(scan.ranges.size(), line);
  ++scans_;
  account(kMeasurementMemory + kRangeMemory * (scan.ranges.size() + scan.remissions.size()), line);
  log_.measurements.emplace_back(std::move(scan));
}

void LogBuilder::add(RfidDetections round, long line) {
  if (!stamp_is_usable(round.time, line)) return;
  std::set<std::string_view> heard;
  for (const RfidRead& read : round.reads) {
    if (!heard.insert(read.tag).second) warn(line, "a tag twice in one inventory round");
  }
  std::size_t bytes = 0;
  for (RfidRead& read : round.reads) {
    if (read.has_phase()) read.phase -= 2.0 * kPi * std::floor(read.phase / (2.0 * kPi));
    bytes += sizeof read + read.tag.size();
  }
  account(kMeasurementMemory + bytes, line);
  log_.measurements.emplace_back(std::move(round));
}

void LogBuilder::state_bearings(LaserScan& scan, double field_of_view, long line) {
  const LineBearings stated =
      bearings_of_line(scan.first_bearing, field_of_view, scan.bearing_step, scan.ranges.size());
  scan.first_bearing = stated.bearings.first;
  scan.bearing_step = stated.bearings.step;
  if (!stated.note.empty()) warn(line, stated.note);
  if (stated.other) other_bearings_[scan.laser] = *stated.other;
}

void LogBuilder::forget_scans() {
  std::erase_if(log_.measurements,
                [](const Measurement& m) { return std::holds_alternative<LaserScan>(m); });
  last_scan_of_laser_.clear();
  readings_of_laser_.clear();
  scans_ = 0;
}

void LogBuilder::add_true_pose(const Stamped<Pose2>& pose, long line) {
  if (!std::isfinite(pose.time) || !is_finite(pose.pose)) {
    broken(line, "true pose that is not a pose: left out");
    return;
  }
  account(2 * sizeof pose, line);
  log_.true_poses.push_back(pose);
  log_.true_poses.back().pose.theta = normalized_angle(pose.pose.theta);
}

void LogBuilder::set_parameter(std::string name, std::string value, long line) {
  account(kParameterMemory + name.size() + value.size(), line);
  line_of_parameter_[name] = line;
  log_.parameters[std::move(name)] = std::move(value);
}

void LogBuilder::refuse_unknown_scans(const std::map<std::size_t, long>& scans_of_beams) const {
  std::string counts;
  for (const auto& [beams, count] : scans_of_beams) {
    if (counts.size() > 60) {
      counts += ", …";
      break;
    }
    counts += (counts.empty() ? "" : ", ") + std::to_string(beams);
  }
  throw InputError(
      place(first_line_of_beams_.at(scans_of_beams.begin()->first)),
      fmt::format("holds {} scans of {} beams, whose fields of view are not known", scans_, counts),
      "set field_of_view, or bearing_step");
}

// What the lines left open. Scans of which the bearings are not known are left out, unless they are
// the larger part: then it is not for us to guess.
void LogBuilder::complete_geometry() {
  const auto [unknown, notes] = complete_lasers(log_, options_, other_bearings_);
  for (const auto& [parameter, note] : notes)
    warn(line_of_parameter_[parameter], parameter + ": " + note);
  long left = scans_;
  for (const auto& [beams, count] : unknown) left -= count;
  if (left == 0 && unknown.size() > 1) refuse_unknown_scans(unknown);
  for (const auto& [beams, count] : unknown) {
    const long line = first_line_of_beams_.at(beams);
    const std::string reason = fmt::format("the field of view of {} beams is not known", beams);
    if (2 * count > scans_)
      throw InputError(place(line), reason, "set field_of_view, or bearing_step");
    warn(line, reason + ": scan left out");
    log_.warnings.back().count = count;
  }
}

void LogBuilder::check_counts() const {
  const bool any = std::any_of(log_.measurements.begin(), log_.measurements.end(),
                               [](auto& m) { return !std::holds_alternative<Odometry>(m); });
  if (!any && broken_ == 0)
    throw InputError({name_}, "holds no laser scan",
                     "a map needs lines such as FLASER or ROBOTLASER1");
  if (!any || (broken_ > 1 && 10 * broken_ > messages_))
    throw InputError(
        first_broken_.place,
        fmt::format("{} ({} of {} messages are broken)", first_broken_.reason, broken_, messages_),
        remedy_.empty() ? "the file is damaged or not of this format; fetch it again" : remedy_);
}

RecordedLog LogBuilder::finish(const std::string& format) {
  log_.format = format;
  complete_geometry();
  check_counts();
  complete_max_range(log_, options_);
  look_at_zeros();
  if (stamps_are_lost(log_.measurements)) {
    warn(0, fmt::format("all scans have the same time stamp: taken as {} s apart",
                        options_.scan_period));
    make_up_stamps(log_.measurements, options_.scan_period);
    log_.has_stamps = false;
  }
  if (out_of_order_) std::stable_sort(log_.measurements.begin(), log_.measurements.end(), earlier);
  std::stable_sort(log_.true_poses.begin(), log_.true_poses.end(),
                   [](const auto& a, const auto& b) { return a.time < b.time; });
  CHECK(std::is_sorted(log_.measurements.begin(), log_.measurements.end(), earlier));
  return std::move(log_);
}

}  // namespace mapbed
