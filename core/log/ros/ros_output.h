#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/log/ros/ros_input.h"
#include "core/log/ros/ros_messages.h"

namespace mapbed {

// [ns] of a time in seconds, to the nearest.
std::int64_t nanoseconds_of(double seconds);

// The fields of a message, one after the other: what RosInput reads.
class RosOutput {
 public:
  explicit RosOutput(RosEncoding encoding);

  template <class T>
  void number(T value) {
    static_assert(std::is_arithmetic_v<T>);
    align(sizeof value);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void text(std::string_view text);
  void raw(std::string_view bytes) { bytes_ += bytes; }
  void header(const RosHeader& header);
  void pose(const Pose3& pose);
  void floats(const std::vector<double>& values);
  void zeros(std::size_t count);  // 64-bit numbers
  std::string bytes() && { return std::move(bytes_); }

 private:
  void align(std::size_t size);

  bool is_cdr_ = false;
  std::string bytes_;
};

std::string message_of(const RosLaserScan& scan, RosEncoding encoding);
std::string message_of(const RosOdometry& odometry, RosEncoding encoding);
std::string message_of(const std::vector<RosTransform>& transforms, RosEncoding encoding);
std::string message_of(const RosPose& pose, RosEncoding encoding);

}  // namespace mapbed
