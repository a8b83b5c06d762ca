#include "core/log/dialects/carmen_log.h"

#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "core/file/tokens.h"
#include "core/geometry/angle.h"
#include "core/log/dialects/dialects.h"
#include "core/log/log_builder.h"
#include "core/log/log_reader.h"

namespace mapbed {
namespace {

Pose2 read_pose(Tokens& tokens) {
  const double x = tokens.number();
  const double y = tokens.number();
  return {x, y, tokens.number()};
}

// The place of a laser from two printed poses is good to their digits; more of them are noise.
Pose2 to_micrometers(const Pose2& pose) {
  const auto rounded = [](double v) { return std::round(v * 1e6) / 1e6 + 0.0; };
  return {rounded(pose.x), rounded(pose.y), normalized_angle(rounded(pose.theta))};
}

constexpr int kMostLasers = 100;

// The laser, from 0, of "ROBOTLASER1", whose lines begin with `name`; none of another line.
std::optional<int> laser_of(std::string_view kind, std::string_view name) {
  int number = 0;
  if (!kind.starts_with(name) || !parse_number(kind.substr(name.size()), number)) return {};
  if (number < 1 || number > kMostLasers) return {};
  return number - 1;
}

// What a LASERMOUNT line says.
struct LaserMount {
  double z = 0.0;            // [m]
  double pitch = 0.0;        // [rad]
  double roll = 0.0;         // [rad]
  double beam_period = 0.0;  // [s]
};

bool is_sensible(const LaserMount& mount) {
  return std::abs(mount.z) <= 1e3 && std::abs(mount.pitch) <= kPi && std::abs(mount.roll) <= kPi &&
         std::abs(mount.beam_period) <= 1.0;
}

// From 0, of a number that counts from 1; none where it is no such number.
std::optional<int> numbered(Tokens& tokens) {
  const double number = tokens.number();
  if (!(number >= 1.0 && number <= kMostLasers) || number != std::floor(number)) return {};
  return static_cast<int>(number) - 1;
}

bool are_the_same(const Odometry& a, const Odometry& b) {
  return a.time == b.time && a.odometry_from_robot == b.odometry_from_robot &&
         a.forward_velocity == b.forward_velocity && a.turn_velocity == b.turn_velocity;
}

class CarmenReader : public LogLineReader {
 public:
  CarmenReader(const std::string& name, const LogOptions& options)
      : LogLineReader(name), builder_(name, options) {}

  void add_line(std::string_view line, long number) override {
    Tokens tokens(line);
    if (tokens.at_end()) return;
    const std::string_view kind = tokens.word();
    if (kind[0] == '#') return;
    line_ = number;
    ++messages_;
    if (kind == "FLASER") return read_laser(tokens, 0);
    if (kind == "RLASER") return read_laser(tokens, 1);
    if (kind == "ODOM") return read_odometry(tokens);
    if (const auto laser = laser_of(kind, "ROBOTLASER")) return read_robot_laser(tokens, *laser);
    if (const auto laser = laser_of(kind, "RAWLASER")) return read_raw_laser(tokens, *laser);
    if (kind == "LASERMOUNT") return read_mount(tokens);
    if (kind == "RFID") return read_rfid(tokens);
    if (kind == "RFIDMOUNT") return read_rfid_mount(tokens);
    if (kind == "TRUEPOS") return read_true_pose(tokens);
    if (kind == "PARAM") return read_parameter(tokens);
    skip(kind);
  }

  // Any text that begins with a capital comes here.
  RecordedLog finish_lines() override {
    if (messages_ == unknown_) refuse_unknown_text(builder_.name());
    return builder_.finish("CARMEN");
  }

 private:
  struct LastScan {
    int laser = 0;
    Odometry odometry;
  };

  // ipc_stamp host logger_stamp; the oldest logs have the first only.
  double read_stamp(Tokens& tokens) {
    const double ipc = tokens.number();
    double logger = ipc;
    if (tokens.ok() && !tokens.at_end()) {
      tokens.word();
      logger = tokens.number();
    }
    const bool want_ipc = builder_.options().stamp == Stamp::ipc;
    double time = want_ipc ? ipc : logger;
    if (time == 0.0) time = want_ipc ? logger : ipc;
    if (time == 0.0 && last_stamp_ != 0.0 && tokens.ok()) {
      builder_.warn(line_, "no time stamp: that of the line before is taken");
      time = last_stamp_;
    }
    return time;
  }

  // False for a line that is cut short or has something else where a number belongs.
  bool complete(const Tokens& tokens, const char* kind) {
    if (tokens.ok()) return true;
    builder_.garbled(line_, std::string(kind) + " line", tokens);
    return false;
  }

  void read_laser(Tokens& tokens, int laser) {
    LaserScan scan;
    set_laser(scan, laser);
    scan.robot_from_laser.planar = kMountToBeTold;
    scan.ranges = tokens.counted_numbers();
    read_pose(tokens);
    const Pose2 odometry = read_pose(tokens);
    scan.time = read_stamp(tokens);
    if (!complete(tokens, laser == 0 ? "FLASER" : "RLASER")) return;
    add(Odometry{scan.time, odometry}, std::move(scan));
  }

  void read_robot_laser(Tokens& tokens, int laser) {
    LaserScan scan = read_scan(tokens, laser);
    const Pose2 odometry_from_laser = read_pose(tokens);
    Odometry odometry;
    odometry.odometry_from_robot = read_pose(tokens);
    odometry.forward_velocity = tokens.number();
    odometry.turn_velocity = tokens.number();
    for (int i = 0; i < 3; ++i) tokens.number();  // safety distances, turn axis
    odometry.time = scan.time = read_stamp(tokens);
    if (!complete(tokens, "ROBOTLASER") || !sensible(scan)) return;
    scan.robot_from_laser.planar =
        to_micrometers(inverse(odometry.odometry_from_robot) * odometry_from_laser);
    add(odometry, std::move(scan));
  }

  // The same without a pose. The logger writes both where it is told so: then these are left.
  void read_raw_laser(Tokens& tokens, int laser) {
    LaserScan scan = read_scan(tokens, laser);
    scan.robot_from_laser.planar = kMountToBeTold;
    scan.time = read_stamp(tokens);
    if (has_robot_scans_) return skip("RAWLASER");
    if (!complete(tokens, "RAWLASER") || !sensible(scan)) return;
    has_raw_scans_ = true;
    last_stamp_ = scan.time;
    builder_.add(std::move(scan), line_);
  }

  void read_mount(Tokens& tokens) {
    const std::optional<int> laser = numbered(tokens);
    LaserMount mount;
    for (double* const value : {&mount.z, &mount.pitch, &mount.roll, &mount.beam_period})
      *value = tokens.number();
    read_stamp(tokens);
    if (!complete(tokens, "LASERMOUNT")) return;
    if (!laser || !is_sensible(mount))
      return builder_.broken(line_, "LASERMOUNT line without a sensible mount: left out");
    mounts_[*laser] = mount;
  }

  void set_laser(LaserScan& scan, int laser) const {
    scan.laser = laser;
    const auto found = mounts_.find(laser);
    if (found == mounts_.end()) return;
    const LaserMount& mount = found->second;
    scan.robot_from_laser = {{}, mount.z, mount.pitch, mount.roll};
    scan.beam_period = mount.beam_period;
  }

  LaserScan read_scan(Tokens& tokens, int laser) {
    LaserScan scan;
    set_laser(scan, laser);
    tokens.number();  // type
    scan.first_bearing = tokens.number();
    const double field_of_view = tokens.number();
    scan.bearing_step = tokens.number();
    scan.max_range = tokens.number();
    tokens.number();  // accuracy
    tokens.number();  // remission mode
    scan.ranges = tokens.counted_numbers();
    scan.remissions = tokens.counted_numbers();
    if (tokens.ok()) builder_.state_bearings(scan, field_of_view, line_);
    return scan;
  }

  bool sensible(const LaserScan& scan) {
    if (std::abs(scan.first_bearing) <= 2.0 * kPi && std::abs(scan.bearing_step) <= 2.0 * kPi &&
        scan.max_range >= 0.0 && scan.max_range <= 1e6)
      return true;
    builder_.broken(line_, "laser line without a sensible scan geometry: left out");
    return false;
  }

  void add(const Odometry& odometry, LaserScan scan) {
    if (has_raw_scans_ && !has_robot_scans_) {
      builder_.warn(line_, "RAWLASER messages are not used where others have the pose, too");
      builder_.forget_scans();
    }
    has_robot_scans_ = true;
    last_stamp_ = scan.time;
    // Of lasers that scan at one moment, each line repeats the odometry.
    const bool repeats = last_scan_ && last_scan_->laser != scan.laser &&
                         are_the_same(last_scan_->odometry, odometry);
    if (!repeats) builder_.add(odometry, line_);
    last_scan_ = {scan.laser, odometry};
    builder_.add(std::move(scan), line_);
  }

  void read_odometry(Tokens& tokens) {
    Odometry odometry;
    odometry.odometry_from_robot = read_pose(tokens);
    odometry.forward_velocity = tokens.number();
    odometry.turn_velocity = tokens.number();
    tokens.number();  // acceleration
    odometry.time = read_stamp(tokens);
    if (!complete(tokens, "ODOM")) return;
    last_stamp_ = odometry.time;
    builder_.add(odometry, line_);
  }

  // RFIDMOUNT antenna x y theta z pitch roll
  void read_rfid_mount(Tokens& tokens) {
    const std::optional<int> antenna = numbered(tokens);
    Mount mount;
    mount.planar = read_pose(tokens);
    for (double* const value : {&mount.z, &mount.pitch, &mount.roll}) *value = tokens.number();
    read_stamp(tokens);
    if (!complete(tokens, "RFIDMOUNT")) return;
    const bool is_near = std::abs(mount.planar.x) <= 1e3 && std::abs(mount.planar.y) <= 1e3;
    if (!antenna || !is_near || !is_sensible({mount.z, mount.pitch, mount.roll}))
      return builder_.broken(line_, "RFIDMOUNT line without a sensible mount: left out");
    antennas_[*antenna] = mount;
  }

  // RFID antenna frequency n, then tag, RSSI and phase of each of n reads
  void read_rfid(Tokens& tokens) {
    RfidDetections round;
    const std::optional<int> antenna = numbered(tokens);
    round.frequency = tokens.number();
    round.reads.resize(tokens.count());
    for (RfidRead& read : round.reads) {
      read.tag = tokens.word();
      read.rssi = tokens.number();
      read.phase = tokens.number();
    }
    round.time = read_stamp(tokens);
    if (!complete(tokens, "RFID")) return;
    const auto mount = antenna ? antennas_.find(*antenna) : antennas_.end();
    if (mount == antennas_.end() || !(round.frequency >= 0.0 && round.frequency <= 1e12))
      return builder_.broken(line_, "RFID line of an antenna without an RFIDMOUNT line: left out");
    round.antenna = *antenna;
    round.robot_from_antenna = mount->second;
    last_stamp_ = round.time;
    builder_.add(std::move(round), line_);
  }

  void read_true_pose(Tokens& tokens) {
    Stamped<Pose2> truth;
    truth.pose = read_pose(tokens);
    read_pose(tokens);
    truth.time = read_stamp(tokens);
    if (complete(tokens, "TRUEPOS")) builder_.add_true_pose(truth, line_);
  }

  void read_parameter(Tokens& tokens) {
    const std::string_view name = tokens.word();
    const std::string_view value = tokens.word();
    if (complete(tokens, "PARAM"))
      builder_.set_parameter(std::string(name), std::string(value), line_);
  }

  void skip(std::string_view kind) {
    ++unknown_;
    const bool is_name =
        std::isalpha(static_cast<unsigned char>(kind[0])) != 0 && kind.size() <= 32;
    if (is_name && known_kinds_.size() < 50) known_kinds_.emplace(kind);
    if (is_name && known_kinds_.contains(std::string(kind)))
      builder_.warn(line_, fmt::format("{} messages are not used", kind));
    else
      builder_.broken(line_, "line that is not a CARMEN message: left out");
  }

  LogBuilder builder_;
  long line_ = 0;
  long messages_ = 0;
  long unknown_ = 0;         // of them, of no kind that is read
  double last_stamp_ = 0.0;  // [s]
  bool has_raw_scans_ = false;
  bool has_robot_scans_ = false;
  std::optional<LastScan> last_scan_;  // that came with odometry
  std::set<std::string> known_kinds_;
  std::map<int, LaserMount> mounts_;
  std::map<int, Mount> antennas_;
};

// Kinds of messages are words in capitals.
bool fits(const LogBeginning& beginning) {
  return !beginning.line.empty() &&
         std::isupper(static_cast<unsigned char>(beginning.line[0])) != 0;
}

}  // namespace

LogDialect carmen_dialect() {
  return {"CARMEN", fits,
          [](const std::string& name, const LogOptions& options) -> std::unique_ptr<LogReader> {
            return std::make_unique<CarmenReader>(name, options);
          }};
}

}  // namespace mapbed
