#include "core/log/bags/bag_messages.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "core/log/ros/ros_output.h"

namespace mapbed {
namespace {

constexpr const char* kRobot = "base_link";

struct Laser {
  int topic = 0;
  std::string frame;
  const LaserScan* first = nullptr;
  const LaserScan* last = nullptr;
  long scans = 0;
};

std::string numbered(const std::string& name, int laser) {
  return laser == 0 ? name : fmt::format("{}_{}", name, laser + 1);
}

// float must not round a hit up to the maximum, where nothing is hit.
double range_of(const LaserScan& scan, std::size_t beam) {
  if (!(scan.ranges[beam] > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  if (scan.is_max_range(beam)) return std::numeric_limits<double>::infinity();
  const auto range = static_cast<float>(scan.ranges[beam]);
  const auto most = static_cast<float>(scan.max_range);
  return static_cast<double>(range < most ? range : std::nextafter(most, 0.0F));
}

RosLaserScan message_of(const LaserScan& scan, const Laser& laser) {
  const std::size_t gaps = scan.ranges.empty() ? 0 : scan.ranges.size() - 1;
  RosLaserScan message;
  message.header = {scan.time, laser.frame};
  message.angle_min = scan.first_bearing;
  message.angle_max = scan.bearing(gaps);
  message.angle_increment = scan.bearing_step;
  message.time_increment = scan.beam_period;
  if (laser.scans > 1)
    message.scan_time =
        (laser.last->time - laser.first->time) / static_cast<double>(laser.scans - 1);
  message.range_max = scan.max_range;
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam)
    message.ranges.push_back(range_of(scan, beam));
  message.intensities = scan.remissions;
  return message;
}

class Collector {
 public:
  Collector(const RecordedLog& log, RosEncoding encoding) : log_(log) { bag_.encoding = encoding; }

  BagToWrite collect() {
    list_topics();
    write_mounts();
    auto truth = log_.true_poses.begin();
    for (const Measurement& measurement : log_.measurements) {
      for (; truth != log_.true_poses.end() && truth->time <= time_of(measurement); ++truth)
        write(*truth);
      std::visit([this](const auto& m) { write(m); }, measurement);
    }
    for (; truth != log_.true_poses.end(); ++truth) write(*truth);
    return std::move(bag_);
  }

 private:
  int add_topic(const std::string& name, RosType type, bool is_latched = false) {
    bag_.topics.push_back({name, type, is_latched});
    return static_cast<int>(bag_.topics.size() - 1);
  }

  void list_topics() {
    bool has_odometry = false;
    for (const Measurement& measurement : log_.measurements) {
      const auto* scan = std::get_if<LaserScan>(&measurement);
      has_odometry = has_odometry || std::holds_alternative<Odometry>(measurement);
      if (scan == nullptr) continue;
      Laser& laser = lasers_[scan->laser];
      if (laser.first == nullptr) laser.first = scan;
      laser.last = scan;
      ++laser.scans;
      if (!(scan->robot_from_laser == laser.first->robot_from_laser))
        throw InputError({},
                         fmt::format("a bag cannot say that the mount of a laser changes, as "
                                     "at {:.6f} s",
                                     scan->time),
                         "write a CARMEN log");
    }
    for (auto& [number, laser] : lasers_) {
      laser.frame = numbered("laser", number);
      laser.topic = add_topic(numbered("/scan", number), RosType::laser_scan);
    }
    if (has_odometry) {
      odometry_ = add_topic("/odom", RosType::odometry);
      transforms_ = add_topic("/tf", RosType::transforms);
    }
    if (!lasers_.empty()) mounts_ = add_topic("/tf_static", RosType::transforms, true);
    if (!log_.true_poses.empty()) truth_ = add_topic("/truth/pose", RosType::pose);
  }

  template <class Message>
  void add(int topic, double time, const Message& message) {
    if (!(time >= 0.0 && time < 4294967295.0))
      throw InputError({}, fmt::format("a bag has no stamp such as {} s", time),
                       "stamps of bags are seconds since 1970");
    bag_.messages.push_back(
        {topic, nanoseconds_of(time), mapbed::message_of(message, bag_.encoding)});
  }

  double first_time() const {
    double time = time_of(log_.measurements.front());
    if (!log_.true_poses.empty()) time = std::min(time, log_.true_poses.front().time);
    return time;
  }

  void write_mounts() {
    if (lasers_.empty()) return;
    std::vector<RosTransform> mounts;
    for (const auto& [number, laser] : lasers_)
      mounts.push_back({{first_time(), kRobot}, laser.frame, laser.first->robot_from_laser.pose()});
    add(mounts_, first_time(), mounts);
  }

  void write(const LaserScan& scan) {
    const Laser& laser = lasers_.at(scan.laser);
    add(laser.topic, scan.time, message_of(scan, laser));
  }

  void write(const RfidDetections& round) {
    throw InputError({}, fmt::format("ROS has no message for RFID, as at {:.6f} s", round.time),
                     "write a CARMEN log");
  }

  void write(const Odometry& odometry) {
    const RosHeader header{odometry.time, "odom"};
    const Pose3 pose = upright(odometry.odometry_from_robot);
    add(odometry_, odometry.time,
        RosOdometry{header, kRobot, pose, odometry.forward_velocity, odometry.turn_velocity});
    add(transforms_, odometry.time, std::vector<RosTransform>{{header, kRobot, pose}});
  }

  void write(const Stamped<Pose2>& truth) {
    add(truth_, truth.time, RosPose{{truth.time, "world"}, upright(truth.pose)});
  }

  const RecordedLog& log_;
  BagToWrite bag_;
  std::map<int, Laser> lasers_;
  int odometry_ = 0, transforms_ = 0, mounts_ = 0, truth_ = 0;  // topics
};

}  // namespace

std::vector<long> BagToWrite::counts() const {
  std::vector<long> counts(topics.size(), 0);
  for (const MessageToWrite& message : messages) ++counts[static_cast<std::size_t>(message.topic)];
  return counts;
}

BagToWrite bag_messages(const RecordedLog& log, RosEncoding encoding) {
  return Collector(log, encoding).collect();
}

}  // namespace mapbed
