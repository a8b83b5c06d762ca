#include "core/log/dialects/carmen_log.h"

#include <cctype>
#include <cmath>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "core/file/fields.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

Pose2 read_pose(Fields& fields) {
  const double x = fields.number();
  const double y = fields.number();
  return {x, y, fields.number()};
}

// The place of a laser from two printed poses is good to their digits; more of them are noise.
Pose2 to_micrometers(const Pose2& pose) {
  const auto rounded = [](double v) { return std::round(v * 1e6) / 1e6 + 0.0; };
  return {rounded(pose.x), rounded(pose.y), normalized_angle(rounded(pose.theta))};
}

class CarmenReader : public LogReader {
 public:
  CarmenReader(const std::string& name, const LogOptions& options) : builder_(name, options) {}

  void add_line(std::string_view line, long number) override {
    Fields fields(line);
    if (fields.at_end()) return;
    const std::string_view kind = fields.word();
    if (kind[0] == '#') return;
    line_ = number;
    if (kind == "FLASER") return read_laser(fields, 0);
    if (kind == "RLASER") return read_laser(fields, 1);
    if (kind == "ODOM") return read_odometry(fields);
    if (kind.starts_with("ROBOTLASER") && kind.size() == 11 && kind[10] >= '1' && kind[10] <= '9')
      return read_robot_laser(fields, kind[10] - '1');
    if (kind.starts_with("RAWLASER") && kind.size() == 9 && kind[8] >= '1' && kind[8] <= '9')
      return read_raw_laser(fields, kind[8] - '1');
    if (kind == "TRUEPOS") return read_true_pose(fields);
    if (kind == "PARAM") return read_parameter(fields);
    skip(kind);
  }

  RecordedLog finish() override { return builder_.finish("CARMEN"); }

 private:
  // ipc_stamp host logger_stamp; the oldest logs have the first only.
  double read_stamp(Fields& fields) {
    const double ipc = fields.number();
    double logger = ipc;
    if (fields.ok() && !fields.at_end()) {
      fields.word();
      logger = fields.number();
    }
    const bool want_ipc = builder_.options().stamp == Stamp::ipc;
    double time = want_ipc ? ipc : logger;
    if (time == 0.0) time = want_ipc ? logger : ipc;
    if (time == 0.0 && last_stamp_ != 0.0 && fields.ok()) {
      builder_.warn(line_, "no time stamp: that of the line before is taken");
      time = last_stamp_;
    }
    return time;
  }

  // False for a line that is cut short or has something else where a number belongs.
  bool complete(const Fields& fields, const char* kind) {
    if (fields.ok()) return true;
    builder_.broken(line_, fmt::format("truncated or garbled {} line: left out", kind));
    return false;
  }

  void read_laser(Fields& fields, int laser) {
    LaserScan scan;
    scan.laser = laser;
    scan.robot_from_laser.planar = kMountToBeTold;
    scan.ranges = fields.counted_numbers();
    read_pose(fields);
    const Pose2 odometry = read_pose(fields);
    scan.time = read_stamp(fields);
    if (!complete(fields, laser == 0 ? "FLASER" : "RLASER")) return;
    add(Odometry{scan.time, odometry}, std::move(scan));
  }

  void read_robot_laser(Fields& fields, int laser) {
    LaserScan scan = read_scan(fields, laser);
    const Pose2 odometry_from_laser = read_pose(fields);
    Odometry odometry;
    odometry.odometry_from_robot = read_pose(fields);
    odometry.forward_velocity = fields.number();
    odometry.turn_velocity = fields.number();
    for (int i = 0; i < 3; ++i) fields.number();  // safety distances, turn axis
    odometry.time = scan.time = read_stamp(fields);
    if (!complete(fields, "ROBOTLASER") || !sensible(scan)) return;
    scan.robot_from_laser.planar =
        to_micrometers(inverse(odometry.odometry_from_robot) * odometry_from_laser);
    add(odometry, std::move(scan));
  }

  // The same without a pose. The logger writes both where it is told so: then these are left.
  void read_raw_laser(Fields& fields, int laser) {
    LaserScan scan = read_scan(fields, laser);
    scan.robot_from_laser.planar = kMountToBeTold;
    scan.time = read_stamp(fields);
    if (has_robot_scans_) return skip("RAWLASER");
    if (!complete(fields, "RAWLASER") || !sensible(scan)) return;
    has_raw_scans_ = true;
    last_stamp_ = scan.time;
    builder_.add(std::move(scan), line_);
  }

  LaserScan read_scan(Fields& fields, int laser) {
    LaserScan scan;
    scan.laser = laser;
    fields.number();  // type
    scan.first_bearing = fields.number();
    const double field_of_view = fields.number();
    scan.bearing_step = fields.number();
    scan.max_range = fields.number();
    fields.number();  // accuracy
    fields.number();  // remission mode
    scan.ranges = fields.counted_numbers();
    scan.remissions = fields.counted_numbers();
    if (scan.bearing_step == 0.0 && scan.ranges.size() > 1)
      scan.bearing_step = field_of_view / static_cast<double>(scan.ranges.size() - 1);
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
    builder_.add(odometry, line_);
    builder_.add(std::move(scan), line_);
  }

  void read_odometry(Fields& fields) {
    Odometry odometry;
    odometry.odometry_from_robot = read_pose(fields);
    odometry.forward_velocity = fields.number();
    odometry.turn_velocity = fields.number();
    fields.number();  // acceleration
    odometry.time = read_stamp(fields);
    if (!complete(fields, "ODOM")) return;
    last_stamp_ = odometry.time;
    builder_.add(odometry, line_);
  }

  void read_true_pose(Fields& fields) {
    Stamped<Pose2> truth;
    truth.pose = read_pose(fields);
    read_pose(fields);
    truth.time = read_stamp(fields);
    if (complete(fields, "TRUEPOS")) builder_.add_true_pose(truth, line_);
  }

  void read_parameter(Fields& fields) {
    const std::string_view name = fields.word();
    const std::string_view value = fields.word();
    if (complete(fields, "PARAM")) builder_.set_parameter(std::string(name), std::string(value));
  }

  void skip(std::string_view kind) {
    const bool is_name =
        std::isalpha(static_cast<unsigned char>(kind[0])) != 0 && kind.size() <= 32;
    if (is_name && known_kinds_.size() < 50) known_kinds_.emplace(kind);
    if (is_name && known_kinds_.contains(std::string(kind)))
      builder_.warn(line_, fmt::format("{} messages are not used", kind));
    else
      builder_.broken(line_, "line that is no CARMEN message: left out");
  }

  LogBuilder builder_;
  long line_ = 0;
  double last_stamp_ = 0.0;  // [s]
  bool has_raw_scans_ = false;
  bool has_robot_scans_ = false;
  std::set<std::string> known_kinds_;
};

}  // namespace

std::unique_ptr<LogReader> make_carmen_reader(const std::string& name, const LogOptions& options) {
  return std::make_unique<CarmenReader>(name, options);
}

}  // namespace mapbed
