#pragma once

#include <string>

#include "core/log/ros/ros_messages.h"
#include "core/sensor/laser_scan.h"

namespace mapbed {

// A scan of ours from one of ROS, by REP 117: a range of +inf says that nothing was hit; NaN, -inf
// and what is below range_min says nothing at all (kNoReading; of 0 see LogOptions::zero); what
// lies above range_max is taken as nothing hit, as most drivers mean it. The stamp is that of the
// first beam. Still to be told: which laser it is of, and its mount.
struct ConvertedScan {
  LaserScan scan;
  double field_of_view = 0.0;  // [rad] from the first to the last beam, as the message says it
  std::string remark;          // what is odd; empty: nothing
};

// Without ranges where its angles are no numbers.
ConvertedScan converted(RosLaserScan&& message);

// Mounts it. A laser that hangs upside down is mounted upright, with its beams the other way round.
void set_mount(LaserScan& scan, const Pose3& robot_from_laser);

}  // namespace mapbed
