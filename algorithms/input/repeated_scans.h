#pragma once

#include <map>
#include <optional>
#include <vector>

#include "algorithms/input/time_intervals.h"
#include "algorithms/remark.h"
#include "core/config/option.h"
#include "core/sensor/laser_scan.h"
#include "core/sensor/odometry.h"

namespace mapbed {

struct RepeatedScanOptions {
  double distance = 0.02;  // [m] that the robot moved since a scan was new
  double turn = 0.02;      // [rad]
};

template <class Visitor>
void visit_fields(RepeatedScanOptions& o, Visitor&& visit) {
  visit("distance", o.distance, Unit::meter, kNotNegative,
        "after which a scan that is exactly the same is no measurement");
  visit("turn", o.turn, Unit::radian, kNotNegative, "the same of the turn");
}

// A driver that hangs tells its last scan again. Noise repeats itself exactly only where readings
// are coarse and the robot stands: a scan that is the same to the last bit after the robot has
// moved by odometry was not measured, and is emptied. A laser that sees nothing may do so for long.
class RepeatedScans {
 public:
  explicit RepeatedScans(const RepeatedScanOptions& options = {}) : options_(options) {}

  void add(const Odometry& odometry) { odometry_ = odometry.odometry_from_robot; }

  // The scan, without readings where it is no measurement; in order of time.
  LaserScan checked(LaserScan scan);

  // Times in their words are counted from `start` [s].
  std::vector<Remark> remarks(double start) const;

 private:
  struct Newest {
    std::vector<double> ranges;
    std::optional<Pose2> odometry;  // odometry_from_robot when they were new
    TimeIntervals repeated;
  };
  RepeatedScanOptions options_;
  std::optional<Pose2> odometry_;
  std::map<int, Newest> newest_;  // by laser
};

}  // namespace mapbed
