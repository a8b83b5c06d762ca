#include "core/log/dialects/scan_list_log.h"

#include <cmath>
#include <utility>

#include "core/file/fields.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

class ScanListReader : public LogReader {
 public:
  ScanListReader(const std::string& name, const LogOptions& options) : builder_(name, options) {}

  void add_line(std::string_view line, long number) override {
    Fields fields(line);
    if (fields.at_end()) return;
    if (fields.characters().starts_with('#')) return read_header(fields, number);

    LaserScan scan;
    scan.time = fields.number();
    scan.ranges = fields.counted_numbers();
    if (!fields.ok()) return builder_.broken(number, "truncated or garbled scan: left out");
    if (!fields.at_end())
      return builder_.broken(number, "scan with more ranges than it says: left out");
    scan.robot_from_laser.planar = kMountToBeTold;
    scan.first_bearing = first_bearing_;
    scan.bearing_step = bearing_step_;
    scan.max_range = max_range_;
    for (double& r : scan.ranges)
      if (std::isnan(r) || (r >= 0.0 && r < min_range_)) r = 0.0;
    builder_.add(std::move(scan), number);
  }

  RecordedLog finish() override { return builder_.finish("scan list"); }

 private:
  void read_header(Fields& fields, long number) {
    while (!fields.at_end()) {
      const std::string_view key = fields.word();
      double* const value = key == "angle_min"         ? &first_bearing_
                            : key == "angle_increment" ? &bearing_step_
                            : key == "range_min"       ? &min_range_
                            : key == "range_max"       ? &max_range_
                                                       : nullptr;
      if (value == nullptr) continue;
      *value = fields.number();
      if (!fields.ok() || !std::isfinite(*value) || std::abs(*value) > 1e6 ||
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

}  // namespace

std::unique_ptr<LogReader> make_scan_list_reader(const std::string& name,
                                                 const LogOptions& options) {
  return std::make_unique<ScanListReader>(name, options);
}

}  // namespace mapbed
