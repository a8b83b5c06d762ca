#include "core/testing/test_bag.h"

#include <cmath>
#include <cstring>

namespace mapbed {
namespace {

template <class T>
std::string raw(T value) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

std::string counted(const std::string& bytes) {
  return raw(static_cast<std::uint32_t>(bytes.size())) + bytes;
}

std::string stamp(double time) {
  const auto seconds = static_cast<std::uint32_t>(time);
  return raw(seconds) + raw(static_cast<std::uint32_t>(std::lround((time - seconds) * 1e9)));
}

std::string header(double time, const std::string& frame) {
  return raw(std::uint32_t{7}) + stamp(time) + counted(frame);
}

std::string floats(const std::vector<float>& values) {
  std::string bytes = raw(static_cast<std::uint32_t>(values.size()));
  for (const float value : values) bytes += raw(value);
  return bytes;
}

std::string lists(const std::vector<std::vector<float>>& values) {
  std::string bytes = raw(static_cast<std::uint32_t>(values.size()));
  for (const auto& list : values) bytes += floats(list);
  return bytes;
}

// Turned by `theta` about z, then by `roll` about the x that results.
std::string pose_bytes(const Pose2& pose, double roll = 0.0) {
  const double c = std::cos(pose.theta / 2), s = std::sin(pose.theta / 2);
  const double cr = std::cos(roll / 2), sr = std::sin(roll / 2);
  return raw(pose.x) + raw(pose.y) + raw(0.0) + raw(c * sr) + raw(s * sr) + raw(s * cr) +
         raw(c * cr);
}

std::string field(const std::string& name, const std::string& value) {
  return counted(name + "=" + value);
}

std::string record(const std::string& fields, const std::string& data) {
  return counted(fields) + counted(data);
}

}  // namespace

TestBag& TestBag::add_raw(const std::string& topic, const std::string& type,
                          const std::string& md5sum, double time, const std::string& message) {
  const auto [found, is_new] =
      connections_.try_emplace(topic, static_cast<std::uint32_t>(connections_.size()));
  const std::string connection = field("conn", raw(found->second));
  if (is_new)
    records_ += record(connection + field("op", "\x07") + field("topic", topic),
                       field("topic", topic) + field("type", type) + field("md5sum", md5sum) +
                           field("message_definition", "float32 x"));
  records_ += record(connection + field("op", "\x02") + field("time", stamp(time)), message);
  return *this;
}

TestBag& TestBag::add(const std::string& topic, const Scan& scan) {
  std::string message = header(scan.time, scan.frame);
  const auto gaps = static_cast<float>(scan.ranges.size() - 1);
  for (const float value :
       {scan.angle_min, scan.angle_min + gaps * scan.angle_increment, scan.angle_increment,
        scan.time_increment, 0.0F, scan.range_min, scan.range_max})
    message += raw(value);
  message += floats(scan.ranges) + floats({});
  return add_raw(topic, "sensor_msgs/LaserScan", "90c7ef2dc6895d81024acba2ac42f369",
                 scan.recorded != 0.0 ? scan.recorded : scan.time, message);
}

TestBag& TestBag::add_echoes(const std::string& topic, double time,
                             const std::vector<std::vector<float>>& ranges,
                             const std::vector<std::vector<float>>& intensities) {
  std::string message = header(time, "laser");
  const auto gaps = static_cast<float>(ranges.size() - 1);
  for (const float value : {-1.0F, -1.0F + gaps * 0.5F, 0.5F, 0.0F, 0.0F, 0.0F, 8.0F})
    message += raw(value);
  message += lists(ranges) + lists(intensities);
  return add_raw(topic, "sensor_msgs/MultiEchoLaserScan", "6fefb0c6da89d7c8abe4b339f5c2f8fb", time,
                 message);
}

TestBag& TestBag::add_transform(const std::string& topic, const Transform& transform) {
  const std::string message = raw(std::uint32_t{1}) + header(transform.time, transform.parent) +
                              counted(transform.child) + pose_bytes(transform.pose, transform.roll);
  return add_raw(topic, "tf2_msgs/TFMessage", "94810edda583a504dfda3829e70d7eec", transform.time,
                 message);
}

TestBag& TestBag::add_odometry(const std::string& topic, double time, const Pose2& pose,
                               const std::string& child) {
  const std::string covariance(36 * sizeof(double), '\0');
  std::string message = header(time, "odom") + counted(child) + pose_bytes(pose) + covariance;
  for (const double value : {0.5, 0.0, 0.0, 0.0, 0.0, 0.25}) message += raw(value);
  return add_raw(topic, "nav_msgs/Odometry", "cd5e73d190d741a2f92e81eda573aca7", time,
                 message + covariance);
}

TestBag& TestBag::add_pose(const std::string& topic, double time, const Pose2& pose) {
  return add_raw(topic, "geometry_msgs/PoseStamped", "d3812c3cbc69362b77dc0b19b345f8f5", time,
                 header(time, "world") + pose_bytes(pose));
}

std::string TestBag::beginning() {
  const std::string fields = field("op", "\x03") + field("index_pos", raw(std::uint64_t{1})) +
                             field("conn_count", raw(std::uint32_t{1})) +
                             field("chunk_count", raw(std::uint32_t{1}));
  return "#ROSBAG V2.0\n" + record(fields, std::string(64, ' '));
}

std::string TestBag::chunk(const std::string& records, const std::string& packing,
                           std::size_t size) {
  const auto told = static_cast<std::uint32_t>(size != 0 ? size : records.size());
  return record(field("op", "\x05") + field("compression", packing) + field("size", raw(told)),
                records);
}

std::string TestBag::index(std::uint32_t messages, std::uint32_t told) {
  return counted(field("op", "\x04") + field("ver", raw(std::uint32_t{1})) +
                 field("conn", raw(std::uint32_t{0})) + field("count", raw(messages))) +
         raw(told) + std::string(12 * messages, '\x01');
}

std::string TestBag::records() const {
  return records_;
}

std::string TestBag::bytes() const {
  return beginning() + chunk(records_) + index(1, 12);
}

}  // namespace mapbed
