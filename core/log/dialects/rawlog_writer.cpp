#include <algorithm>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstring>

#include "core/file/atomic_file.h"
#include "core/geometry/pose3.h"
#include "core/log/dialects/rawlog.h"
#include "core/log/log_file.h"

namespace mapbed {
namespace {

// Ticks of 0.1 us from the year 1601, where stamps begin, to that of Unix.
constexpr std::uint64_t kTicksBefore1970 = 116'444'736'000'000'000;
constexpr double kTicksPerSecond = 1e7;
constexpr char kEndOfObject = static_cast<char>(0x88);
constexpr char kBeginOfObject = static_cast<char>(0x80);  // with the length of the class's name

// MRPT's archive: numbers with the lowest byte first, texts behind their length.
class Archive {
 public:
  template <std::integral Integer>
  void add(Integer value) {
    for (std::size_t i = 0; i < sizeof(Integer); ++i) {
      bytes_ += static_cast<char>(static_cast<std::uint64_t>(value) >> (8 * i));
    }
  }
  void add(bool value) { bytes_ += static_cast<char>(value ? 1 : 0); }
  void add(float value) { add(std::bit_cast<std::uint32_t>(value)); }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(std::string_view text) {
    add(static_cast<std::uint32_t>(text.size()));
    bytes_ += text;
  }
  void add_stamp(double time) {
    const double ticks = std::round(time * kTicksPerSecond);
    add(kTicksBefore1970 + static_cast<std::uint64_t>(static_cast<std::int64_t>(ticks)));
  }

  // An object of a class, in this version, with what `add_members` adds.
  template <class AddMembers>
  void add_object(std::string_view name, int version, AddMembers&& add_members) {
    bytes_ += static_cast<char>(kBeginOfObject | static_cast<char>(name.size()));
    bytes_ += name;
    bytes_ += static_cast<char>(version);
    add_members();
    bytes_ += kEndOfObject;
  }

  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

void add_pose(Archive& out, const Pose2& pose) {
  out.add_object("CPose2D", 1, [&] {
    for (const double value : {pose.x, pose.y, pose.theta}) out.add(value);
  });
}

void add_pose(Archive& out, const Pose3& pose) {
  const Eigen::Vector3d& p = pose.position;
  const Eigen::Quaterniond& q = pose.rotation;
  out.add_object("CPose3D", 2, [&] {
    for (const double value : {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()}) out.add(value);
  });
}

// With MRPT's own values of its two motion models; programs have theirs in their settings.
void add_motion_models(Archive& out) {
  constexpr std::uint32_t kGaussian = 0, kParticles = 300;
  out.add(kGaussian);
  for (const float value : {0.01f, 0.0573f, 0.01745f, 0.05f, 0.01f, 0.00349f}) out.add(value);
  out.add(kParticles);
  for (const float value : {0.05f, 0.0698f, 0.01f, 0.00573f, 0.001f, 0.000873f}) out.add(value);
}

void add_action(Archive& out, const Pose2& motion, double time) {
  constexpr std::uint32_t kOne = 1, kByOdometry = 0, kNoTicks = 0;
  out.add_object("CActionCollection", 0, [&] {
    out.add(kOne);
    out.add_object("CActionRobotMovement2D", 6, [&] {
      out.add(kByOdometry);
      add_pose(out, motion);
      add_motion_models(out);
      out.add(false);  // velocities, which follow all the same
      for (int i = 0; i < 2; ++i) out.add(0.0f);
      out.add(false);  // encoder ticks, likewise
      for (int i = 0; i < 2; ++i) out.add(kNoTicks);
      out.add_stamp(time);
    });
  });
}

// Beams lie symmetrically about the x axis of a sensor that looks to their middle.
Pose3 robot_from_middle(const LaserScan& scan, double field_of_view) {
  const double middle = scan.bearing_step > 0.0 ? scan.first_bearing + field_of_view / 2.0
                                                : scan.first_bearing - field_of_view / 2.0;
  return scan.robot_from_laser.pose() * upright(Pose2{0.0, 0.0, middle});
}

void add_scan(Archive& out, const LaserScan& scan) {
  constexpr float kSigma = 0.01f, kBeamWidth = 0.00436f;  // [m], [rad] MRPT's own
  const auto beams = static_cast<std::uint32_t>(scan.ranges.size());
  const double field_of_view =
      std::abs(scan.bearing_step) * static_cast<double>(beams > 0 ? beams - 1 : 0);
  out.add_object("CObservation2DRangeScan", 6, [&] {
    out.add(static_cast<float>(field_of_view));
    out.add(scan.bearing_step > 0.0);  // from right to left
    out.add(static_cast<float>(scan.max_range));
    add_pose(out, robot_from_middle(scan, field_of_view));
    out.add(beams);
    for (const double range : scan.ranges) out.add(static_cast<float>(range));
    for (std::size_t i = 0; i < scan.ranges.size(); ++i) out.add(scan.is_hit(i));
    out.add(kSigma);
    out.add_stamp(scan.time);
    out.add(kBeamWidth);
    out.add(std::string_view(scan.laser == 0 ? "front" : scan.laser == 1 ? "rear" : "further"));
    out.add(0.0);  // pitch from beam to beam
  });
}

// Where odometry had the robot; at the first or last reading for a time that it does not reach.
Pose2 odometry_at(const Trajectory& odometry, double time) {
  if (odometry.empty()) return {};
  const double inside = std::clamp(time, odometry.front().time, odometry.back().time);
  return pose_at(odometry, inside).value_or(Pose2{});
}

}  // namespace

std::string rawlog_bytes(const RecordedLog& log) {
  constexpr std::uint32_t kOne = 1;
  Archive out;
  const Trajectory odometry = odometry_of(log.measurements);
  std::optional<Pose2> before;
  for (const Measurement& measurement : log.measurements) {
    const auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr) continue;
    const Pose2 now = odometry_at(odometry, scan->time);
    add_action(out, motion_between(before.value_or(now), now), scan->time);
    before = now;
    out.add_object("CSensoryFrame", 2, [&] {
      out.add(kOne);
      add_scan(out, *scan);
    });
  }
  return out.take();
}

void write_rawlog(const std::string& path, const RecordedLog& log) {
  write_file(path, rawlog_bytes(log), Durability::unsynced);
}

}  // namespace mapbed
