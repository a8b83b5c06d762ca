#include "core/log/bags/bag_log.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/log/ros/ros_scan.h"
#include "core/log/ros/unrounded.h"

namespace mapbed {
namespace {

// A turn that is none stays none.
Pose3 checked(const Pose3& pose) {
  if (std::abs(pose.rotation.norm() - 1.0) < 1e-2) return pose;
  Pose3 none = pose;
  none.position.x() = NAN;
  return none;
}

}  // namespace

BagLog::BagLog(const std::string& name, const LogOptions& options)
    : topics_(name, options.bag), builder_(name, options, LogBuilder::Place::message) {}

std::size_t BagLog::max_bytes() const {
  return static_cast<std::size_t>(builder_.options().max_text);
}

void BagLog::account(std::size_t bytes) {
  memory_ += static_cast<double>(bytes);
  if (memory_ > builder_.options().max_text)
    throw InputError({name()},
                     fmt::format("what is used of its first {} messages takes more than {:.0f} MB",
                                 messages_, builder_.options().max_text / 1e6),
                     "raise log.max_text if the file is to be trusted");
}

void BagLog::remark(const std::string& reason, const std::string& example) {
  if (damage_.empty()) damage_ = reason + example;
  builder_.warn(0, reason, example);
}

void BagLog::add_message(int topic, double time, std::string_view bytes) {
  if (messages_ == 0) first_time_ = last_time_ = time;
  first_time_ = std::min(first_time_, time);
  last_time_ = std::max(last_time_, time);
  ++messages_;
  topics_.count_message(topic);
  if (is_counting_ || !topics_.may_be_used(topic)) return;
  RosInput in(bytes, topics_.at(topic).encoding);
  switch (topics_.type_of(topic)) {
    case RosType::laser_scan:
    case RosType::multi_echo_scan:
      return take_scan(topic, time, in);
    case RosType::transforms:
      return take_transforms(topic, time, in);
    case RosType::odometry:
    case RosType::pose: {
      const bool is_truth = topics_.is_truth(topic);
      return is_truth ? take_truth(topic, time, in) : take_odometry(topic, time, in);
    }
    case RosType::other:
      return;
  }
}

// Messages that are cut short or longer than their fields are left out.
bool BagLog::is_whole(const RosInput& in, int topic) {
  if (in.is_at_end() && !in.is_foreign()) return true;
  const std::string& name = topics_.at(topic).name;
  builder_.broken(messages_,
                  in.is_foreign()
                      ? "message on " + in_quotes(name) + " that is not little-endian CDR: left out"
                      : "truncated or garbled message on " + in_quotes(name) + ": left out");
  return false;
}

double BagLog::stamp_of(const RosHeader& header, double time, int topic) {
  if (header.stamp != 0.0 || time == 0.0) return header.stamp;
  builder_.warn(messages_, "no time stamp on " + in_quotes(topics_.at(topic).name) +
                               ": the time of recording is taken");
  return time;
}

void BagLog::take_scan(int topic, double time, RosInput& in) {
  const bool is_named = !builder_.options().bag.scans.empty();
  if (!is_named && !readings_.scans.empty() && !readings_.scans.contains(topic)) {
    has_several_lasers_ = true;  // which is refused in the end
    readings_.scans.begin()->second.clear();
  }
  if (has_several_lasers_) return;
  const bool has_echoes = topics_.type_of(topic) == RosType::multi_echo_scan;
  const ChosenEcho echo = builder_.options().bag.echo;
  RosLaserScan message = has_echoes ? read_multi_echo_scan(in, echo) : read_laser_scan(in);
  if (!is_whole(in, topic)) return;
  if (has_echoes && !readings_.scans.contains(topic))
    builder_.warn(0, fmt::format("of beams with several echoes the {} counts (log.bag.echo)",
                                 echo == ChosenEcho::first ? "first, the nearest," : "strongest"));
  auto& scans = readings_.scans[topic];
  BagScan read{messages_, message.header.frame};
  message.header.stamp = stamp_of(message.header, time, topic);
  if (watcher_) watcher_(message);
  ConvertedScan scan = converted(std::move(message));
  if (!scan.remark.empty()) builder_.warn(messages_, scan.remark);
  read.field_of_view = scan.field_of_view;
  read.scan = std::move(scan.scan);
  account(2 * sizeof read +
          sizeof(double) * (read.scan.ranges.size() + read.scan.remissions.size()));
  scans.push_back(std::move(read));
}

void BagLog::take_odometry(int topic, double time, RosInput& in) {
  const RosOdometry message = read_ros_odometry(in);
  if (!is_whole(in, topic)) return;
  account(2 * sizeof(BagOdometry));
  readings_.robot_frame.try_emplace(topic, message.child_frame);
  readings_.odometry[topic].push_back({messages_, stamp_of(message.header, time, topic),
                                       checked(message.pose), message.forward, message.turn});
}

void BagLog::take_transforms(int topic, double time, RosInput& in) {
  const std::vector<RosTransform> transforms = read_transforms(in);
  if (!is_whole(in, topic)) return;
  for (const RosTransform& transform : transforms) {
    account(FrameTree::kPoseMemory + transform.header.frame.size() + transform.child_frame.size());
    const double stamp = transform.header.stamp != 0.0 ? transform.header.stamp : time;
    if (!readings_.frames.add(transform.header.frame, transform.child_frame,
                              {stamp, transform.pose}))
      builder_.warn(
          messages_,
          "transform that is none, or of a frame with another parent: left "
          "out",
          ", " + in_quotes(transform.child_frame) + " in " + in_quotes(transform.header.frame));
  }
}

void BagLog::take_truth(int topic, double time, RosInput& in) {
  RosPose message;
  if (topics_.type_of(topic) == RosType::pose) {
    message = read_ros_pose(in);
  } else {
    const RosOdometry odometry = read_ros_odometry(in);
    message = {odometry.header, odometry.pose};
  }
  if (!is_whole(in, topic)) return;
  const double stamp = stamp_of(message.header, time, topic);
  builder_.add_true_pose({stamp, unrounded_plan(checked(message.pose))}, messages_);
}

BagContents BagLog::contents(const std::string& format) const {
  return {format, topics_.told(), last_time_ - first_time_};
}

RecordedLog BagLog::finish(const std::string& format) {
  if (!damage_.empty() && !topics_.has_scans())
    throw InputError({name()}, damage_ + ", where no laser scan stands",
                     "fetch or copy the file again");
  if (messages_ == 0) throw InputError({name()}, "holds no messages", "record it again");
  const std::vector<int> lasers = assemble(std::move(readings_), topics_, builder_);
  RecordedLog log = builder_.finish(format);
  for (RecordedLaser& laser : log.lasers)
    if (laser.source == "its lines")
      laser.source = topics_.at(lasers.at(static_cast<std::size_t>(laser.laser))).name;
  return log;
}

}  // namespace mapbed
