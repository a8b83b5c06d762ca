#include "core/log/dialects/scan_list_log.h"

#include <cmath>
#include <utility>

#include "core/file/tokens.h"
#include "core/geometry/angle.h"
#include "core/log/laser_geometry.h"
#include "core/log/log_builder.h"
#include "core/log/log_reader.h"

namespace mapbed {
namespace {

class ScanListReader : public LogLineReader {
 public:
  ScanListReader(const std::string& name, const LogOptions& options)
      : LogLineReader(name), builder_(name, options) {}

  void add_line(std::string_view line, long number) override {
    Tokens tokens(line);
    if (tokens.at_end()) return;
    if (tokens.rest().starts_with('#')) return read_header(tokens, number);

    LaserScan scan;
    scan.time = tokens.number();
    scan.ranges = tokens.counted_numbers();
    if (!tokens.ok()) return builder_.garbled(number, "scan", tokens);
    if (!tokens.at_end())
      return builder_.broken(number, "scan with more ranges than it says: left out");
    scan.robot_from_laser.planar = kMountToBeTold;
    scan.first_bearing = first_bearing_;
    scan.bearing_step = bearing_step_;
    scan.max_range = max_range_;
    for (double& r : scan.ranges)
      if (std::isnan(r) || (r > 0.0 && r < min_range_)) r = kNoReading;
    builder_.add(std::move(scan), number);
  }

  RecordedLog finish_lines() override { return builder_.finish("scan list"); }

 private:
  void read_header(Tokens& tokens, long number) {
    while (!tokens.at_end()) {
      const std::string_view key = tokens.word();
      double* const value = key == "angle_min"         ? &first_bearing_
                            : key == "angle_increment" ? &bearing_step_
                            : key == "range_min"       ? &min_range_
                            : key == "range_max"       ? &max_range_
                                                       : nullptr;
      if (value == nullptr) continue;
      *value = tokens.number();
      if (!tokens.ok() || !std::isfinite(*value) || std::abs(*value) > 1e6 ||
          (value == &bearing_step_ && (*value == 0.0 || std::abs(*value) > kPi)) ||
          ((value == &max_range_ || value == &min_range_) && *value < 0.0))
        throw InputError({builder_.name(), number}, "no sensible number after " + std::string(key),
                         "the header states the scan's geometry in rad and m");
    }
  }

  LogBuilder builder_;
  double first_bearing_ = 0.0;  // [rad]
  double bearing_step_ = 0.0;   // [rad] 0: no header, told by the number of beams
  double min_range_ = 0.0;      // [m]
  double max_range_ = 0.0;      // [m]
};

// A header, or `t n r…` with as many ranges as it says.
bool fits(const LogBeginning& beginning) {
  Tokens tokens(beginning.line);
  tokens.number();
  if (!tokens.ok()) return false;
  if (beginning.header.find("angle_min") != std::string_view::npos) return true;
  const std::size_t n = tokens.count();
  return tokens.ok() && n > 0 && words_in(tokens.rest()) == n;
}

}  // namespace

LogDialect scan_list_dialect() {
  return {"`t n ranges` lines", fits,
          [](const std::string& name, const LogOptions& options) -> std::unique_ptr<LogReader> {
            return std::make_unique<ScanListReader>(name, options);
          }};
}

}  // namespace mapbed
