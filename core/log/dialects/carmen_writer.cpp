#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "core/file/text_file.h"
#include "core/file/tokens.h"
#include "core/geometry/angle.h"
#include "core/log/dialects/carmen_log.h"
#include "core/log/laser_geometry.h"

namespace mapbed {
namespace {

// fmt's {} of a double is the shortest decimal that reads back as the same bits.
class Writer {
 public:
  template <class... Values>
  void print(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
  }
  void pose(const Pose2& pose) { print(" {} {} {}", pose.x, pose.y, pose.theta); }
  void numbers(const std::vector<double>& values) {
    print(" {}", values.size());
    for (const double value : values) print(" {}", value);
  }
  void stamp(double time) { print(" {} nohost {}\n", time, time); }
  std::string text() const { return fmt::to_string(text_); }

 private:
  fmt::memory_buffer text_;
};

void write_geometry(Writer& out, const LaserScan& scan) {
  const auto gaps = static_cast<double>(std::max<std::size_t>(scan.ranges.size(), 1) - 1);
  out.print("{} 0 {} {} {} {} 0.01 0", scan.laser + 1, scan.first_bearing, scan.bearing_step * gaps,
            scan.bearing_step, scan.max_range);
  out.numbers(scan.ranges);
  out.numbers(scan.remissions);
}

void write_robotlaser(Writer& out, const LaserScan& scan, const Odometry& odometry) {
  out.print("ROBOTLASER");
  write_geometry(out, scan);
  out.pose(odometry.odometry_from_robot * scan.robot_from_laser.planar);
  out.pose(odometry.odometry_from_robot);
  out.print(" {} {} 0 0 0", odometry.forward_velocity, odometry.turn_velocity);
  out.stamp(scan.time);
}

void write_rawlaser(Writer& out, const LaserScan& scan) {
  out.print("RAWLASER");
  write_geometry(out, scan);
  out.stamp(scan.time);
}

void write_flaser(Writer& out, const LaserScan& scan, const Odometry& odometry) {
  out.print("{}", scan.laser == 1 ? "RLASER" : "FLASER");
  out.numbers(scan.ranges);
  out.pose(odometry.odometry_from_robot * scan.robot_from_laser.planar);
  out.pose(odometry.odometry_from_robot);
  out.stamp(scan.time);
}

void write_odometry(Writer& out, const Odometry& odometry) {
  out.print("ODOM");
  out.pose(odometry.odometry_from_robot);
  out.print(" {} {} 0", odometry.forward_velocity, odometry.turn_velocity);
  out.stamp(odometry.time);
}

void write_rfid_mount(Writer& out, const RfidDetections& round) {
  const Mount& mount = round.robot_from_antenna;
  out.print("RFIDMOUNT {}", round.antenna + 1);
  out.pose(mount.planar);
  out.print(" {} {} {}", mount.z, mount.pitch, mount.roll);
  out.stamp(round.time);
}

void write_rfid(Writer& out, const RfidDetections& round) {
  out.print("RFID {} {} {}", round.antenna + 1, round.frequency, round.reads.size());
  for (const RfidRead& read : round.reads) {
    if (read.tag.empty() || words_in(read.tag) != 1)
      throw InputError({}, "a log cannot name the tag " + in_quotes(read.tag),
                       "take names of one word");
    out.print(" {} {} {}", read.tag, read.rssi, read.phase);
  }
  out.stamp(round.time);
}

void write_true_pose(Writer& out, const Stamped<Pose2>& truth, const Odometry& odometry) {
  out.print("TRUEPOS");
  out.pose(truth.pose);
  out.pose(odometry.odometry_from_robot);
  out.stamp(truth.time);
}

// The first scan of each laser, by its number.
std::map<int, const LaserScan*> lasers_of(const RecordedLog& log) {
  std::map<int, const LaserScan*> lasers;
  for (const Measurement& m : log.measurements)
    if (const auto* scan = std::get_if<LaserScan>(&m)) lasers.try_emplace(scan->laser, scan);
  return lasers;
}

// What the lines themselves do not say of a laser.
void set_parameters(std::map<std::string, std::string>& parameters, const LaserScan& scan) {
  const LaserParameterNames names = parameter_names_of(scan.laser);
  const Pose2& pose = scan.robot_from_laser.planar;
  parameters[names.mount + "offset"] = fmt::format("{}", pose.x);
  parameters[names.mount + "side_offset"] = fmt::format("{}", pose.y);
  parameters[names.mount + "angular_offset"] =
      fmt::format("{}", scan.laser == 1 ? normalized_angle(pose.theta - kPi) : pose.theta);
  parameters[names.bearings + "resolution"] = fmt::format("{}", degrees(scan.bearing_step));
  parameters[names.bearings + "fov"] = fmt::format("{}", degrees(-2.0 * scan.first_bearing));
  if (!fit(-2.0 * scan.first_bearing, scan.bearing_step, scan.ranges.size()))
    parameters[names.bearings + "first_bearing"] = fmt::format("{}", degrees(scan.first_bearing));
  parameters[names.max_range] = fmt::format("{}", scan.max_range);
}

void write_parameters(Writer& out, const std::map<std::string, std::string>& parameters) {
  for (const auto& [name, value] : parameters) out.print("PARAM {} {} nohost 0\n", name, value);
}

// Writes a LASERMOUNT line where a scan differs from its laser's last in what no other line says.
class MountWriter {
 public:
  explicit MountWriter(Writer& out) : out_(out) {}

  void write_if_new(const LaserScan& scan) {
    const Mount& mount = scan.robot_from_laser;
    const std::array<double, 4> now = {mount.z, mount.pitch, mount.roll, scan.beam_period};
    std::array<double, 4>& last = last_of_laser_[scan.laser];
    if (now == last) return;
    last = now;
    out_.print("LASERMOUNT {} {} {} {} {}", scan.laser + 1, now[0], now[1], now[2], now[3]);
    out_.stamp(scan.time);
  }

  void write_if_new(const RfidDetections& round) {
    const auto [known, is_new] = antennas_.try_emplace(round.antenna, round.robot_from_antenna);
    if (!is_new && known->second == round.robot_from_antenna) return;
    known->second = round.robot_from_antenna;
    write_rfid_mount(out_, round);
  }

 private:
  Writer& out_;
  std::map<int, std::array<double, 4>> last_of_laser_;  // all 0 at first
  std::map<int, Mount> antennas_;
};

// All measurements and true poses by time; odometry right before a scan of its stamp is in the
// scan's own line.
template <class WriteScan>
void write_messages(Writer& out, const RecordedLog& log, WriteScan write_scan) {
  Odometry odometry;
  MountWriter mounts(out);
  auto truth = log.true_poses.begin();
  for (std::size_t i = 0; i < log.measurements.size(); ++i) {
    const double time = time_of(log.measurements[i]);
    for (; truth != log.true_poses.end() && truth->time <= time; ++truth)
      write_true_pose(out, *truth, odometry);
    if (const auto* scan = std::get_if<LaserScan>(&log.measurements[i])) {
      mounts.write_if_new(*scan);
      write_scan(*scan, odometry);
      continue;
    }
    if (const auto* round = std::get_if<RfidDetections>(&log.measurements[i])) {
      mounts.write_if_new(*round);
      write_rfid(out, *round);
      continue;
    }
    odometry = std::get<Odometry>(log.measurements[i]);
    const bool in_scan = i + 1 < log.measurements.size() &&
                         std::holds_alternative<LaserScan>(log.measurements[i + 1]) &&
                         time_of(log.measurements[i + 1]) == time;
    if (!in_scan) write_odometry(out, odometry);
  }
  for (; truth != log.true_poses.end(); ++truth) write_true_pose(out, *truth, odometry);
}

bool has_odometry(const RecordedLog& log) {
  return std::any_of(log.measurements.begin(), log.measurements.end(),
                     [](const Measurement& m) { return std::holds_alternative<Odometry>(m); });
}

void check_fits_flaser(const LaserScan& scan, const LaserScan& first) {
  const bool same =
      scan.first_bearing == first.first_bearing && scan.bearing_step == first.bearing_step &&
      scan.ranges.size() == first.ranges.size() && scan.robot_from_laser == first.robot_from_laser;
  if (scan.laser > 1 || !same || !(scan.first_bearing < 0.0 && scan.bearing_step > 0.0))
    throw InputError(
        {}, fmt::format("FLASER lines cannot say the geometry of the scan at {:.6f}", scan.time),
        "write ROBOTLASER lines");
}

}  // namespace

std::string carmen_text(const RecordedLog& log) {
  Writer out;
  const bool with_pose = has_odometry(log);
  auto parameters = log.parameters;
  if (!with_pose)
    for (const auto& [laser, scan] : lasers_of(log)) set_parameters(parameters, *scan);
  write_parameters(out, parameters);
  write_messages(out, log, [&](const LaserScan& scan, const Odometry& odometry) {
    if (with_pose)
      write_robotlaser(out, scan, odometry);
    else
      write_rawlaser(out, scan);
  });
  return out.text();
}

std::string old_carmen_text(const RecordedLog& log) {
  Writer out;
  const auto lasers = lasers_of(log);
  auto parameters = log.parameters;
  for (const auto& [laser, scan] : lasers) set_parameters(parameters, *scan);
  write_parameters(out, parameters);
  write_messages(out, log, [&](const LaserScan& scan, const Odometry& odometry) {
    check_fits_flaser(scan, *lasers.at(scan.laser));
    write_flaser(out, scan, odometry);
  });
  return out.text();
}

void write_carmen_log(const std::string& path, const RecordedLog& log, CarmenDialect dialect) {
  write_text_file(path, dialect == CarmenDialect::flaser ? old_carmen_text(log) : carmen_text(log));
}

}  // namespace mapbed
