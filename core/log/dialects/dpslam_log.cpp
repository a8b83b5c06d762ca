#include "core/log/dialects/dpslam_log.h"

#include <utility>

#include <fmt/core.h>

#include "core/file/tokens.h"
#include "core/log/log_builder.h"
#include "core/log/log_reader.h"

namespace mapbed {
namespace {

class DpslamReader : public LogLineReader {
 public:
  DpslamReader(const std::string& name, const LogOptions& options)
      : LogLineReader(name), builder_(name, options) {}

  void add_line(std::string_view line, long number) override {
    Tokens tokens(line);
    if (tokens.at_end()) return;
    const std::string_view kind = tokens.word();
    if (kind[0] == '#') return;
    if (kind == "Odometry") return read_odometry(tokens, number);
    if (kind == "Laser") return read_laser(tokens, number);
    builder_.broken(number, "line that is neither Odometry nor Laser: left out");
  }

  RecordedLog finish_lines() override {
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

  void read_odometry(Tokens& tokens, long number) {
    Odometry odometry;
    odometry.time = now();
    odometry.odometry_from_robot.x = tokens.number();
    odometry.odometry_from_robot.y = tokens.number();
    odometry.odometry_from_robot.theta = tokens.number();
    if (!tokens.ok()) return builder_.garbled(number, "Odometry line", tokens);
    builder_.add(odometry, number);
  }

  void read_laser(Tokens& tokens, long number) {
    LaserScan scan;
    scan.time = now();
    scan.robot_from_laser.planar = kMountToBeTold;
    scan.ranges = tokens.counted_numbers();
    if (!tokens.ok()) return builder_.garbled(number, "Laser line", tokens);
    builder_.add(std::move(scan), number);
  }

  LogBuilder builder_;
};

bool fits(const LogBeginning& beginning) {
  const std::string_view kind = Tokens(beginning.line).word();
  return kind == "Odometry" || kind == "Laser";
}

}  // namespace

LogDialect dpslam_dialect() {
  return {"DP-SLAM", fits,
          [](const std::string& name, const LogOptions& options) -> std::unique_ptr<LogReader> {
            return std::make_unique<DpslamReader>(name, options);
          }};
}

}  // namespace mapbed
