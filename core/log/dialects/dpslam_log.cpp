#include "core/log/dialects/dpslam_log.h"

#include <utility>

#include <fmt/core.h>

#include "core/file/fields.h"

namespace mapbed {
namespace {

class DpslamReader : public LogReader {
 public:
  DpslamReader(const std::string& name, const LogOptions& options) : builder_(name, options) {}

  void add_line(std::string_view line, long number) override {
    Fields fields(line);
    if (fields.at_end()) return;
    const std::string_view kind = fields.word();
    if (kind[0] == '#') return;
    if (kind == "Odometry") return read_odometry(fields, number);
    if (kind == "Laser") return read_laser(fields, number);
    builder_.broken(number, "line that is neither Odometry nor Laser: left out");
  }

  RecordedLog finish() override {
    builder_.warn(0, fmt::format("the format has no time stamps: scans are taken as {} s apart",
                                 builder_.options().scan_period));
    RecordedLog log = builder_.finish("DP-SLAM");
    log.has_stamps = false;
    return log;
  }

 private:
  double now() const {
    return static_cast<double>(builder_.scans()) * builder_.options().scan_period;
  }

  void read_odometry(Fields& fields, long number) {
    Odometry odometry;
    odometry.time = now();
    odometry.odometry_from_robot.x = fields.number();
    odometry.odometry_from_robot.y = fields.number();
    odometry.odometry_from_robot.theta = fields.number();
    if (!fields.ok()) return builder_.broken(number, "truncated Odometry line: left out");
    builder_.add(odometry, number);
  }

  void read_laser(Fields& fields, long number) {
    LaserScan scan;
    scan.time = now();
    scan.robot_from_laser.planar = kMountToBeTold;
    scan.ranges = fields.counted_numbers();
    if (!fields.ok()) return builder_.broken(number, "truncated Laser line: left out");
    builder_.add(std::move(scan), number);
  }

  LogBuilder builder_;
};

}  // namespace

std::unique_ptr<LogReader> make_dpslam_reader(const std::string& name, const LogOptions& options) {
  return std::make_unique<DpslamReader>(name, options);
}

}  // namespace mapbed
