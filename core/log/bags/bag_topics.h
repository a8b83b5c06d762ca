#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/log/log_file.h"
#include "core/log/ros/ros_definitions.h"

namespace mapbed {

// A topic as a bag says it.
struct BagTopic {
  std::string name;
  std::string type;  // by either name
  RosEncoding encoding = RosEncoding::other;
  std::string md5sum = {};      // ROS 1; empty: not told
  std::string definition = {};  // empty: not told
};

// The topics of a bag, numbered as they come, and which of them are used.
class BagTopics {
 public:
  BagTopics(std::string bag, const BagOptions& options) : bag_(std::move(bag)), options_(options) {}

  // One that was there before, with the same type, keeps its number.
  int add(const BagTopic& topic);
  void count_message(int topic) { ++entries_[static_cast<std::size_t>(topic)].told.messages; }

  const BagTopic& at(int topic) const { return entries_[static_cast<std::size_t>(topic)].topic; }
  RosType type_of(int topic) const { return entries_[static_cast<std::size_t>(topic)].type; }
  bool is_truth(int topic) const;
  bool has_scans() const;
  std::vector<RecordedTopic> told() const;

  // Whether messages of this one can be of use, as far as it is known while they are read. Throws
  // InputError where it is, and its messages are not those that are known by that name.
  bool may_be_used(int topic);

  // Throw InputError where there is none or more than one that fits, with the list of them.
  std::vector<int> scans() const;
  std::optional<int> odometry() const;  // none: tf, or nothing
  void check_truth() const;             // that it is there, where it is named

 private:
  struct Entry {
    BagTopic topic;
    RosType type = RosType::other;
    RecordedTopic told;
    bool is_checked = false;
  };

  bool fits(const Entry& entry) const;
  void check(const Entry& entry) const;
  int named(const std::string& name, const std::string& option, bool (*is_right)(RosType),
            std::string_view kind) const;
  template <class Fits>
  std::vector<int> with_messages(Fits fits) const;
  std::string list(const std::vector<int>& topics) const;  // "/scan (360 sensor_msgs/LaserScan), …"
  std::string list_all() const;

  std::string bag_;
  BagOptions options_;
  std::vector<Entry> entries_;
};

}  // namespace mapbed
