#pragma once

#include <string>
#include <string_view>

#include "core/log/ros/ros_input.h"

// Which messages of ROS are known here, and their definitions: what bags carry of them is compared
// with, and written by us.

namespace mapbed {

enum class RosType : int { laser_scan, multi_echo_scan, odometry, transforms, pose, other };

// "sensor_msgs/LaserScan", as ROS 1 writes it, of "sensor_msgs/msg/LaserScan".
std::string short_type_name(std::string_view type);

RosType ros_type_of(std::string_view type);   // by either name
std::string_view type_name_of(RosType type);  // the short one
std::string_view md5sum_of(RosType type);     // by which ROS 1 tells its definition
std::string definition_of(RosType type, RosEncoding encoding);  // with all that it is made of

// Whether messages so defined have the same fields in the same order, whatever the text says
// besides: comments, constants, whole names.
bool has_fields_of(RosType type, RosEncoding encoding, std::string_view definition);

}  // namespace mapbed
