#pragma once

#include <string>

namespace mapbed {

// How a topic is published, as ROS 2 writes it into its bags. Empty: by default. Without it nobody
// who listens later would be told what is published once.
inline std::string qos_profile(bool is_latched) {
  if (!is_latched) return {};
  const std::string forever = "\n    sec: 9223372036\n    nsec: 854775807";
  return "- history: 1\n  depth: 1\n  reliability: 1\n  durability: 1\n  deadline:" + forever +
         "\n  lifespan:" + forever + "\n  liveliness: 1\n  liveliness_lease_duration:" + forever +
         "\n  avoid_ros_namespace_conventions: false";
}

}  // namespace mapbed
