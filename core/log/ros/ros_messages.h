#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/pose3.h"
#include "core/log/ros/ros_input.h"

// The messages of ROS that are read from bags and written to them, as they stand there.

namespace mapbed {

struct RosHeader {
  double stamp = 0.0;  // [s] 0: none
  std::string frame;   // without a slash in front
};

// sensor_msgs/LaserScan, and sensor_msgs/MultiEchoLaserScan with one echo of each beam.
struct RosLaserScan {
  RosHeader header;
  double angle_min = 0.0;        // [rad]
  double angle_max = 0.0;        // [rad]
  double angle_increment = 0.0;  // [rad]
  double time_increment = 0.0;   // [s]
  double scan_time = 0.0;        // [s] from one scan to the next; 0: not told
  double range_min = 0.0;        // [m]
  double range_max = 0.0;        // [m]
  std::vector<double> ranges;    // [m]
  std::vector<double> intensities;
};

enum class ChosenEcho : int;  // bag_options.h

// nav_msgs/Odometry; covariances are left out.
struct RosOdometry {
  RosHeader header;
  std::string child_frame;
  Pose3 pose;            // header.frame from child_frame
  double forward = 0.0;  // [m/s] in the child's frame
  double turn = 0.0;     // [rad/s]
};

// geometry_msgs/TransformStamped, of which tf2_msgs/TFMessage is a list.
struct RosTransform {
  RosHeader header;
  std::string child_frame;
  Pose3 pose;  // header.frame from child_frame
};

// geometry_msgs/PoseStamped
struct RosPose {
  RosHeader header;
  Pose3 pose;
};

// What `in` holds after them tells whether the message was one: ok() and is_at_end().
RosLaserScan read_laser_scan(RosInput& in);
RosLaserScan read_multi_echo_scan(RosInput& in, ChosenEcho echo);
RosOdometry read_ros_odometry(RosInput& in);
std::vector<RosTransform> read_transforms(RosInput& in);
RosPose read_ros_pose(RosInput& in);

}  // namespace mapbed
