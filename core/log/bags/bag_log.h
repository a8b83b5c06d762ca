#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "core/log/bags/bag_assembly.h"
#include "core/log/ros/ros_messages.h"

// Bags of ROS 1 and ROS 2, read without ROS. Of their messages count
//
//   sensor_msgs/LaserScan, sensor_msgs/MultiEchoLaserScan   scans; of several echoes one
//   nav_msgs/Odometry                                       odometry, the frame of the robot
//   tf2_msgs/TFMessage on tf and tf_static                  mounts; odometry where none is above
//   geometry_msgs/PoseStamped, nav_msgs/Odometry            true poses
//
// by the stamps in their headers; where one is 0, by the time at which the message was recorded.

namespace mapbed {

class BagLog {
 public:
  BagLog(const std::string& name, const LogOptions& options);

  // Of the bag, or of the file of it that is read.
  const std::string& name() const { return part_.empty() ? builder_.name() : part_; }
  void begin_part(const std::string& path) { part_ = path; }
  void end_parts() { part_.clear(); }
  long messages() const { return messages_; }  // so far
  std::size_t max_bytes() const;               // that anything packed may come to

  // What the reader of a kind of bag finds, in the order of the file.
  int add_topic(const BagTopic& topic) { return topics_.add(topic); }
  void add_message(int topic, double time, std::string_view bytes);
  // The bag itself is damaged or odd; what could be read counts.
  void remark(const std::string& reason, const std::string& example = {});

  // Called with each scan as the bag has it, before anything is made of it.
  void watch_scans(std::function<void(const RosLaserScan&)> watcher) {
    watcher_ = std::move(watcher);
  }
  void count_only() { is_counting_ = true; }  // for contents() alone
  BagContents contents(const std::string& format) const;
  RecordedLog finish(const std::string& format);  // throws InputError

 private:
  void take_scan(int topic, double time, RosInput& in);
  void take_odometry(int topic, double time, RosInput& in);
  void take_transforms(int topic, double time, RosInput& in);
  void take_truth(int topic, double time, RosInput& in);
  bool is_whole(const RosInput& in, int topic);
  double stamp_of(const RosHeader& header, double time, int topic);
  void account(std::size_t bytes);

  BagTopics topics_;
  LogBuilder builder_;
  BagReadings readings_;
  long messages_ = 0;
  double first_time_ = 0.0;  // [s] of recording
  double last_time_ = 0.0;
  double memory_ = 0.0;  // [bytes]
  bool is_counting_ = false;
  bool has_several_lasers_ = false;  // of which none is named
  std::string damage_;               // the first remark
  std::string part_;                 // path of the file that is read, where there are several
  std::function<void(const RosLaserScan&)> watcher_;
};

}  // namespace mapbed
