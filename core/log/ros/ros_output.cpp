#include "core/log/ros/ros_output.h"

#include <cmath>

namespace mapbed {

std::int64_t nanoseconds_of(double seconds) {
  const double whole = std::floor(seconds);
  return static_cast<std::int64_t>(whole) * 1'000'000'000 +
         static_cast<std::int64_t>(std::llround((seconds - whole) * 1e9));
}

RosOutput::RosOutput(RosEncoding encoding) : is_cdr_(encoding == RosEncoding::cdr) {
  if (is_cdr_) bytes_.assign({0, 1, 0, 0});
}

void RosOutput::align(std::size_t size) {
  if (!is_cdr_) return;
  while ((bytes_.size() - 4) % size != 0) bytes_.push_back('\0');
}

void RosOutput::text(std::string_view text) {
  number(static_cast<std::uint32_t>(text.size() + (is_cdr_ ? 1 : 0)));
  bytes_ += text;
  if (is_cdr_) bytes_.push_back('\0');
}

void RosOutput::header(const RosHeader& header) {
  if (!is_cdr_) number(std::uint32_t{0});  // sequence
  const std::int64_t stamp = nanoseconds_of(header.stamp);
  number(static_cast<std::int32_t>(stamp / 1'000'000'000));
  number(static_cast<std::uint32_t>(stamp % 1'000'000'000));
  text(header.frame);
}

void RosOutput::pose(const Pose3& pose) {
  for (const double value : pose.position) number(value);
  for (const double value : pose.rotation.coeffs()) number(value);  // x, y, z, w
}

void RosOutput::floats(const std::vector<double>& values) {
  number(static_cast<std::uint32_t>(values.size()));
  for (const double value : values) number(static_cast<float>(value));
}

void RosOutput::zeros(std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) number(0.0);
}

std::string message_of(const RosLaserScan& scan, RosEncoding encoding) {
  RosOutput out(encoding);
  out.header(scan.header);
  for (const double value : {scan.angle_min, scan.angle_max, scan.angle_increment,
                             scan.time_increment, scan.scan_time, scan.range_min, scan.range_max})
    out.number(static_cast<float>(value));
  out.floats(scan.ranges);
  out.floats(scan.intensities);
  return std::move(out).bytes();
}

std::string message_of(const RosOdometry& odometry, RosEncoding encoding) {
  constexpr std::size_t kCovariance = 36;
  RosOutput out(encoding);
  out.header(odometry.header);
  out.text(odometry.child_frame);
  out.pose(odometry.pose);
  out.zeros(kCovariance);
  for (const double value : {odometry.forward, 0.0, 0.0, 0.0, 0.0, odometry.turn})
    out.number(value);
  out.zeros(kCovariance);
  return std::move(out).bytes();
}

std::string message_of(const std::vector<RosTransform>& transforms, RosEncoding encoding) {
  RosOutput out(encoding);
  out.number(static_cast<std::uint32_t>(transforms.size()));
  for (const RosTransform& transform : transforms) {
    out.header(transform.header);
    out.text(transform.child_frame);
    out.pose(transform.pose);
  }
  return std::move(out).bytes();
}

std::string message_of(const RosPose& pose, RosEncoding encoding) {
  RosOutput out(encoding);
  out.header(pose.header);
  out.pose(pose.pose);
  return std::move(out).bytes();
}

}  // namespace mapbed
