#include "core/log/bags/bag_topics.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/config/suggestion.h"

namespace mapbed {
namespace {

constexpr std::size_t kMostListed = 30;
constexpr std::size_t kMostTopics = 10'000;

bool is_scan_type(RosType type) {
  return type == RosType::laser_scan || type == RosType::multi_echo_scan;
}

bool is_odometry_type(RosType type) {
  return type == RosType::odometry;
}

bool is_pose_type(RosType type) {
  return type == RosType::pose || type == RosType::odometry;
}

std::string without_slash(const std::string& name) {
  return name.starts_with('/') ? name.substr(1) : name;
}

// "scan" means "/scan", too.
bool is_called(const BagTopic& topic, const std::string& name) {
  return without_slash(topic.name) == without_slash(name);
}

bool is_tf(const BagTopic& topic) {
  return is_called(topic, "tf") || is_called(topic, "tf_static");
}

}  // namespace

int BagTopics::add(const BagTopic& topic) {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    BagTopic& known = entries_[i].topic;
    if (known.name != topic.name || known.type != topic.type || known.encoding != topic.encoding)
      continue;
    if (known.md5sum != topic.md5sum || known.definition != topic.definition) {
      known = topic;
      entries_[i].is_checked = false;
    }
    return static_cast<int>(i);
  }
  if (entries_.size() == kMostTopics)
    throw InputError({bag_}, fmt::format("has more than {} topics", kMostTopics));
  const RosType type = ros_type_of(topic.type);
  const bool is_foreign = topic.encoding == RosEncoding::other;
  RecordedTopic told{topic.name, short_type_name(topic.type)};
  if (type == RosType::other)
    told.unread = "no measurement here is of this kind";
  else if (is_foreign)
    told.unread = "its messages are neither those of ROS 1 nor CDR";
  entries_.push_back({topic, is_foreign ? RosType::other : type, std::move(told)});
  return static_cast<int>(entries_.size() - 1);
}

std::vector<RecordedTopic> BagTopics::told() const {
  std::vector<RecordedTopic> topics;
  for (const Entry& entry : entries_) {
    const auto same = std::find_if(topics.begin(), topics.end(), [&](const RecordedTopic& t) {
      return t.name == entry.told.name && t.type == entry.told.type;
    });
    if (same == topics.end())
      topics.push_back(entry.told);
    else
      same->messages += entry.told.messages;
  }
  std::sort(topics.begin(), topics.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
  return topics;
}

bool BagTopics::fits(const Entry& entry) const {
  const auto is_named = [&](const std::string& name) { return is_called(entry.topic, name); };
  if (is_scan_type(entry.type))
    return options_.scans.empty() ||
           std::any_of(options_.scans.begin(), options_.scans.end(), is_named);
  if (entry.type == RosType::transforms) return is_tf(entry.topic);
  if (is_pose_type(entry.type) && is_named(options_.truth)) return true;
  return entry.type == RosType::odometry &&
         (options_.odometry.empty() || is_named(options_.odometry));
}

void BagTopics::check(const Entry& entry) const {
  const BagTopic& topic = entry.topic;
  const bool has_md5sum = !topic.md5sum.empty() && topic.md5sum != "*";
  const bool is_known =
      has_md5sum
          ? topic.md5sum == md5sum_of(entry.type)
          : topic.definition.empty() || has_fields_of(entry.type, topic.encoding, topic.definition);
  if (is_known) return;
  throw InputError({bag_},
                   fmt::format("{} is called {}, but its messages have other fields than those of "
                               "ROS by that name",
                               in_quotes(topic.name), in_quotes(topic.type)),
                   "name the topics that are to be used (log.bag.scans, log.bag.odometry)");
}

bool BagTopics::may_be_used(int topic) {
  Entry& entry = entries_[static_cast<std::size_t>(topic)];
  if (!fits(entry)) return false;
  if (!entry.is_checked) check(entry);
  entry.is_checked = true;
  return true;
}

template <class Fits>
std::vector<int> BagTopics::with_messages(Fits fits) const {
  std::vector<int> found;
  for (std::size_t i = 0; i < entries_.size(); ++i)
    if (entries_[i].told.messages > 0 && fits(entries_[i])) found.push_back(static_cast<int>(i));
  return found;
}

std::string BagTopics::list(const std::vector<int>& topics) const {
  std::string text;
  std::size_t listed = 0;
  for (const int topic : topics) {
    if (listed++ == kMostListed) return text + ", …";
    const RecordedTopic& told = entries_[static_cast<std::size_t>(topic)].told;
    text +=
        fmt::format("{}{} ({} {})", text.empty() ? "" : ", ", told.name, told.messages, told.type);
  }
  return text;
}

std::string BagTopics::list_all() const {
  std::vector<int> all(entries_.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  return all.empty() ? "it has no topics" : "its topics are " + list(all);
}

int BagTopics::named(const std::string& name, const std::string& option, bool (*is_right)(RosType),
                     std::string_view kind) const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (!is_called(entries_[i].topic, name)) {
      names.push_back(entries_[i].topic.name);
      continue;
    }
    if (is_right(entries_[i].type)) return static_cast<int>(i);
    throw InputError({bag_},
                     fmt::format("the topic {} of {} is no {}: its messages are {}",
                                 in_quotes(name), option, kind, entries_[i].told.type),
                     list_all());
  }
  const std::string near = nearest(name, names);
  throw InputError({bag_}, fmt::format("has no topic {}, as {} says", in_quotes(name), option),
                   near.empty() ? list_all() : "did you mean " + in_quotes(near) + "?");
}

std::vector<int> BagTopics::scans() const {
  std::vector<int> chosen;
  for (const std::string& name : options_.scans)
    chosen.push_back(named(name, "log.bag.scans", is_scan_type, "laser"));
  if (!chosen.empty()) return chosen;
  chosen = with_messages([](const Entry& entry) { return is_scan_type(entry.type); });
  if (chosen.empty()) throw InputError({bag_}, "holds no laser scan", list_all());
  if (chosen.size() > 1)
    throw InputError({bag_}, "has several lasers: " + list(chosen),
                     fmt::format("name one, or all with the front one first: "
                                 "--set log.bag.scans='[{}]'",
                                 at(chosen.front()).name));
  return chosen;
}

std::optional<int> BagTopics::odometry() const {
  if (options_.odometry == "tf" || options_.odometry == "none") return {};
  if (!options_.odometry.empty())
    return named(options_.odometry, "log.bag.odometry", is_odometry_type, "odometry");
  const std::vector<int> found = with_messages([this](const Entry& entry) {
    return entry.type == RosType::odometry && !is_called(entry.topic, options_.truth);
  });
  if (found.size() > 1)
    throw InputError(
        {bag_}, "has several kinds of odometry: " + list(found),
        fmt::format("name one (--set log.bag.odometry={}), tf or none", at(found.front()).name));
  return found.empty() ? std::nullopt : std::optional(found.front());
}

bool BagTopics::has_scans() const {
  return std::any_of(entries_.begin(), entries_.end(), [](const Entry& entry) {
    return is_scan_type(entry.type) && entry.told.messages > 0;
  });
}

bool BagTopics::is_truth(int topic) const {
  const Entry& entry = entries_[static_cast<std::size_t>(topic)];
  return is_pose_type(entry.type) && is_called(entry.topic, options_.truth);
}

void BagTopics::check_truth() const {
  if (options_.truth.empty() || options_.truth == BagOptions{}.truth) return;
  named(options_.truth, "log.bag.truth", is_pose_type, "pose");
}

}  // namespace mapbed
