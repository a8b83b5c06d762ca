#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/log/log_file.h"
#include "core/log/ros/ros_definitions.h"

namespace mapbed {

struct TopicToWrite {
  std::string name;
  RosType type = RosType::other;
  bool is_latched = false;  // what comes late still gets its last message
};

struct MessageToWrite {
  int topic = 0;          // of the list
  std::int64_t time = 0;  // [ns]
  std::string bytes;
};

// A log as messages of ROS, in the order of their stamps:
//
//   /scan, /scan_2, …    sensor_msgs/LaserScan in the frames laser, laser_2, …: by REP 117, +inf
//                        where nothing was hit, NaN where a beam failed
//   /odom                nav_msgs/Odometry of base_link in odom; /tf has the same
//   /tf_static           the lasers' mounts on base_link
//   /truth/pose          geometry_msgs/PoseStamped in the frame world
struct BagToWrite {
  RosEncoding encoding = RosEncoding::cdr;
  std::vector<TopicToWrite> topics;  // those that have messages
  std::vector<MessageToWrite> messages;

  std::vector<long> counts() const;  // of messages, by topic
};

// Throws InputError where the mount of a laser changes, or a stamp lies before 1970 or after 2106.
BagToWrite bag_messages(const RecordedLog& log, RosEncoding encoding);

}  // namespace mapbed
