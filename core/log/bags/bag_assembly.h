#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/log/bags/bag_topics.h"
#include "core/log/log_builder.h"
#include "core/log/ros/frame_tree.h"

namespace mapbed {

// A scan as it is read, before it is known where its laser sits.
struct BagScan {
  long message = 0;  // number in the bag
  std::string frame;
  double field_of_view = 0.0;  // [rad]
  LaserScan scan;
};

struct BagOdometry {
  long message = 0;
  double time = 0.0;  // [s]
  Pose3 odometry_from_child;
  double forward = 0.0;  // [m/s]
  double turn = 0.0;     // [rad/s]
};

// What the messages of a bag say, each topic in the order of the file.
struct BagReadings {
  std::map<int, std::vector<BagScan>> scans;         // by number of the topic
  std::map<int, std::vector<BagOdometry>> odometry;  // the same
  std::map<int, std::string> robot_frame;            // child_frame of the odometry
  FrameTree frames;
};

// Hands the scans of the chosen lasers, mounted on the robot, and its odometry to the builder, by
// their stamps. Throws InputError where it is not clear which ones are meant. Returns the topics of
// the lasers, by their numbers.
std::vector<int> assemble(BagReadings readings, const BagTopics& topics, LogBuilder& builder);

}  // namespace mapbed
