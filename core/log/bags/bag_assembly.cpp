#include "core/log/bags/bag_assembly.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/log/ros/ros_scan.h"
#include "core/log/ros/unrounded.h"

namespace mapbed {
namespace {

struct Reading {
  long message = 0;
  double field_of_view = 0.0;  // [rad]
  Measurement measurement;
};
using Stream = std::vector<Reading>;

// Where odometry comes from, and the frame of the robot that it is of.
struct OdometryOfBag {
  std::vector<BagOdometry> readings;
  std::string child_frame;
};

// The frame below that of the odometry.
std::string child_of_odometry(const FrameTree& frames, const BagOptions& options) {
  const std::vector<std::string> children = frames.children_of(options.odometry_frame);
  for (const std::string& usual :
       {options.robot_frame, std::string("base_footprint"), std::string("base_link")})
    if (std::find(children.begin(), children.end(), usual) != children.end()) return usual;
  return children.empty() ? "" : children.front();
}

OdometryOfBag odometry_of_transforms(const FrameTree& frames, const BagOptions& options) {
  OdometryOfBag result;
  result.child_frame = child_of_odometry(frames, options);
  const auto* poses = frames.poses_of(result.child_frame);
  if (poses == nullptr) return result;
  for (const Stamped<Pose3>& pose : *poses) {
    // Told again by whoever publishes it.
    if (!result.readings.empty() && result.readings.back().time == pose.time) continue;
    result.readings.push_back({0, pose.time, pose.pose});
  }
  return result;
}

OdometryOfBag odometry_of(BagReadings& readings, const BagTopics& topics,
                          const LogBuilder& builder) {
  const BagOptions& options = builder.options().bag;
  if (const auto topic = topics.odometry())
    return {std::move(readings.odometry[*topic]), readings.robot_frame[*topic]};
  if (options.odometry == "none") return {};
  OdometryOfBag found = odometry_of_transforms(readings.frames, options);
  if (found.readings.empty() && options.odometry == "tf")
    throw InputError({builder.name()},
                     fmt::format("its transforms tell no odometry: nothing hangs on the frame {}",
                                 in_quotes(options.odometry_frame)),
                     "name the frame with log.bag.odometry_frame");
  return found;
}

// Empty: nobody says.
std::string robot_frame_of(const FrameTree& frames, const std::string& child_frame,
                           const BagOptions& options) {
  if (!options.robot_frame.empty()) return options.robot_frame;
  if (!child_frame.empty()) return child_frame;
  for (const char* usual : {"base_footprint", "base_link"})
    if (frames.knows(usual)) return usual;
  return {};
}

Stream stream_of(const OdometryOfBag& odometry, const Pose3& child_from_robot) {
  Stream stream;
  stream.reserve(odometry.readings.size());
  for (const BagOdometry& reading : odometry.readings) {
    const Pose2 pose = unrounded_plan(reading.odometry_from_child * child_from_robot);
    stream.push_back(
        {reading.message, 0.0, Odometry{reading.time, pose, reading.forward, reading.turn}});
  }
  return stream;
}

// Tells where lasers sit, each frame once.
class MountFinder {
 public:
  MountFinder(const FrameTree& frames, std::string robot_frame, bool has_odometry,
              LogBuilder& builder)
      : frames_(frames),
        robot_frame_(std::move(robot_frame)),
        has_odometry_(has_odometry),
        builder_(builder) {}

  void set_mount_of(LaserScan& scan, const std::string& frame) {
    auto found = mounts_.find(frame);
    if (found == mounts_.end()) found = mounts_.emplace(frame, look_for(frame, scan.laser)).first;
    if (found->second)
      set_mount(scan, *found->second);
    else
      scan.robot_from_laser.planar = kMountToBeTold;
  }

 private:
  std::optional<Pose3> look_for(const std::string& frame, int laser) {
    const auto mount = robot_frame_.empty() ? std::nullopt : frames_.mount(robot_frame_, frame);
    if (!mount) {
      const LogOptions& options = builder_.options();
      const bool is_told = laser == 0   ? !options.robot_from_laser.empty()
                           : laser == 1 ? !options.robot_from_rear_laser.empty()
                                        : false;
      // A laser alone may as well be the robot.
      if (has_odometry_ && !is_told)
        builder_.warn(0, fmt::format("no transform tells where the laser's frame {} is on the "
                                     "robot ({}): taken as its centre; log.robot_from_laser says "
                                     "it otherwise",
                                     in_quotes(frame), in_quotes(robot_frame_)));
      return {};
    }
    if (!mount->moving.empty())
      builder_.warn(0, fmt::format("the frame {} moves, and the laser with it: its first pose on "
                                   "the robot is taken for all",
                                   in_quotes(mount->moving)));
    return mount->base_from_frame;
  }

  const FrameTree& frames_;
  std::string robot_frame_;
  bool has_odometry_;
  LogBuilder& builder_;
  std::map<std::string, std::optional<Pose3>> mounts_;
};

Stream stream_of(std::vector<BagScan>& scans, int laser, MountFinder& mounts, LogBuilder& builder) {
  Stream stream;
  stream.reserve(scans.size());
  for (BagScan& read : scans) {
    LaserScan& scan = read.scan;
    scan.laser = laser;
    builder.state_bearings(scan, read.field_of_view, read.message);
    mounts.set_mount_of(scan, read.frame);
    stream.push_back({read.message, read.field_of_view, std::move(scan)});
  }
  return stream;
}

void hand_on(Reading& reading, LogBuilder& builder) {
  if (auto* scan = std::get_if<LaserScan>(&reading.measurement))
    builder.add(std::move(*scan), reading.message);
  else
    builder.add(std::get<Odometry>(reading.measurement), reading.message);
}

// Messages are recorded as they arrive: those of different topics in no order of their stamps.
void merge(std::vector<Stream>& streams, LogBuilder& builder) {
  std::vector<std::size_t> next(streams.size(), 0);
  while (true) {
    std::optional<std::size_t> first;
    for (std::size_t i = 0; i < streams.size(); ++i) {
      if (next[i] == streams[i].size()) continue;
      if (!first || time_of(streams[i][next[i]].measurement) <
                        time_of(streams[*first][next[*first]].measurement))
        first = i;
    }
    if (!first) return;
    hand_on(streams[*first][next[*first]++], builder);
  }
}

}  // namespace

std::vector<int> assemble(BagReadings readings, const BagTopics& topics, LogBuilder& builder) {
  const std::vector<int> lasers = topics.scans();
  topics.check_truth();
  const OdometryOfBag odometry = odometry_of(readings, topics, builder);
  const std::string robot_frame =
      robot_frame_of(readings.frames, odometry.child_frame, builder.options().bag);
  const auto child_from_robot = readings.frames.mount(odometry.child_frame, robot_frame);
  std::vector<Stream> streams;  // the odometry first: at equal stamps it comes first
  streams.push_back(
      stream_of(odometry, child_from_robot ? child_from_robot->base_from_frame : Pose3{}));
  MountFinder mounts(readings.frames, robot_frame, !odometry.readings.empty(), builder);
  for (std::size_t laser = 0; laser < lasers.size(); ++laser)
    streams.push_back(
        stream_of(readings.scans[lasers[laser]], static_cast<int>(laser), mounts, builder));
  merge(streams, builder);
  return lasers;
}

}  // namespace mapbed
