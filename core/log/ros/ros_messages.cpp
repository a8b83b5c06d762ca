#include "core/log/ros/ros_messages.h"

#include <algorithm>
#include <cmath>

#include "core/log/bag_options.h"
#include "core/log/ros/unrounded.h"

namespace mapbed {
namespace {

std::string read_frame(RosInput& in) {
  std::string_view frame = in.text();
  if (frame.starts_with('/')) frame.remove_prefix(1);  // as the first tf wrote it
  return std::string(frame);
}

RosHeader read_header(RosInput& in) {
  in.skip_sequence();
  RosHeader header;
  header.stamp = in.stamp();
  header.frame = read_frame(in);
  return header;
}

Eigen::Vector3d read_vector(RosInput& in) {
  Eigen::Vector3d vector;
  for (double& value : vector) value = in.number<double>();
  return vector;
}

Pose3 read_pose(RosInput& in) {
  Pose3 pose;
  pose.position = read_vector(in);
  for (double& value : pose.rotation.coeffs()) value = in.number<double>();  // x, y, z, w
  return pose;
}

void read_geometry(RosInput& in, RosLaserScan& scan) {
  for (double* const angle : {&scan.angle_min, &scan.angle_max, &scan.angle_increment})
    *angle = unrounded_bearing(in.number<float>());
  for (double* const value :
       {&scan.time_increment, &scan.scan_time, &scan.range_min, &scan.range_max})
    *value = unrounded(in.number<float>());
}

std::vector<std::vector<double>> read_echoes(RosInput& in) {
  std::vector<std::vector<double>> echoes(in.count(sizeof(std::uint32_t)));
  for (auto& of_beam : echoes) {
    of_beam = in.floats();
    if (!in.ok()) return {};
  }
  return echoes;
}

}  // namespace

RosLaserScan read_laser_scan(RosInput& in) {
  RosLaserScan scan;
  scan.header = read_header(in);
  read_geometry(in, scan);
  scan.ranges = in.floats();
  scan.intensities = in.floats();
  return scan;
}

RosLaserScan read_multi_echo_scan(RosInput& in, ChosenEcho echo) {
  RosLaserScan scan;
  scan.header = read_header(in);
  read_geometry(in, scan);
  const auto ranges = read_echoes(in);
  const auto intensities = read_echoes(in);
  for (std::size_t beam = 0; beam < ranges.size(); ++beam) {
    static const std::vector<double> kNone;
    const auto& of_beam = beam < intensities.size() ? intensities[beam] : kNone;
    std::size_t chosen = 0;
    if (echo == ChosenEcho::strongest && of_beam.size() == ranges[beam].size() && !of_beam.empty())
      chosen = static_cast<std::size_t>(std::max_element(of_beam.begin(), of_beam.end()) -
                                        of_beam.begin());
    scan.ranges.push_back(chosen < ranges[beam].size() ? ranges[beam][chosen] : INFINITY);
    if (!intensities.empty())
      scan.intensities.push_back(chosen < of_beam.size() ? of_beam[chosen] : 0.0);
  }
  return scan;
}

RosOdometry read_ros_odometry(RosInput& in) {
  constexpr std::size_t kCovariance = 36;
  RosOdometry odometry;
  odometry.header = read_header(in);
  odometry.child_frame = read_frame(in);
  odometry.pose = read_pose(in);
  in.skip_doubles(kCovariance);
  odometry.forward = read_vector(in).x();
  odometry.turn = read_vector(in).z();
  in.skip_doubles(kCovariance);
  return odometry;
}

std::vector<RosTransform> read_transforms(RosInput& in) {
  constexpr std::size_t kLeastBytes = 72;  // of one with empty names
  std::vector<RosTransform> transforms(in.count(kLeastBytes));
  for (RosTransform& transform : transforms) {
    transform.header = read_header(in);
    transform.child_frame = read_frame(in);
    transform.pose = read_pose(in);
    if (!in.ok()) return {};
  }
  return transforms;
}

RosPose read_ros_pose(RosInput& in) {
  RosPose pose;
  pose.header = read_header(in);
  pose.pose = read_pose(in);
  return pose;
}

}  // namespace mapbed
