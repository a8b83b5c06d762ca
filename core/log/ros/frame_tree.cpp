#include "core/log/ros/frame_tree.h"

#include <algorithm>
#include <cmath>

namespace mapbed {
namespace {

// Of the same mount told twice: digits of a float.
constexpr double kSameDistance = 1e-4;  // [m]
constexpr double kSameAngle = 1e-4;     // [rad]
constexpr std::size_t kLongestLine = 1000;

}  // namespace

bool FrameTree::add(const std::string& parent, const std::string& child,
                    const Stamped<Pose3>& pose) {
  const double length = pose.pose.rotation.norm();
  if (!is_finite(pose.pose) || !std::isfinite(pose.time) || std::abs(length - 1.0) > 1e-2 ||
      parent.empty() || child.empty() || parent == child)
    return false;
  Edge& edge = edges_[child];
  if (edge.poses.empty()) edge.parent = parent;
  if (edge.parent != parent) return false;
  edge.poses.push_back(pose);
  edge.poses.back().pose.rotation.normalize();
  const Pose3& first = edge.poses.front().pose;
  const Pose3& last = edge.poses.back().pose;
  edge.moves = edge.moves || distance(first, last) > kSameDistance ||
               angle_between(first, last) > kSameAngle;
  return true;
}

bool FrameTree::knows(const std::string& frame) const {
  return edges_.contains(frame) || std::any_of(edges_.begin(), edges_.end(), [&](const auto& edge) {
           return edge.second.parent == frame;
         });
}

const std::vector<Stamped<Pose3>>* FrameTree::poses_of(const std::string& frame) const {
  const auto found = edges_.find(frame);
  return found == edges_.end() ? nullptr : &found->second.poses;
}

std::vector<std::string> FrameTree::children_of(const std::string& frame) const {
  std::vector<std::string> children;
  for (const auto& [child, edge] : edges_)
    if (edge.parent == frame) children.push_back(child);
  return children;
}

// Ends where a frame comes up again: then it is no tree. No robot has so long a line.
std::vector<std::string> FrameTree::line_of(const std::string& frame) const {
  std::vector<std::string> line{frame};
  for (auto edge = edges_.find(frame); edge != edges_.end(); edge = edges_.find(line.back())) {
    if (line.size() == kLongestLine ||
        std::find(line.begin(), line.end(), edge->second.parent) != line.end())
      break;
    line.push_back(edge->second.parent);
  }
  return line;
}

Pose3 FrameTree::first_pose(const std::vector<std::string>& line, const std::string& top,
                            std::string& moving) const {
  Pose3 pose;
  for (const std::string& frame : line) {
    if (frame == top) break;
    const Edge& edge = edges_.at(frame);
    if (edge.moves && moving.empty()) moving = frame;
    pose = edge.poses.front().pose * pose;
  }
  return pose;
}

std::optional<FrameTree::Mount> FrameTree::mount(const std::string& base,
                                                 const std::string& frame) const {
  const std::vector<std::string> of_base = line_of(base);
  const std::vector<std::string> of_frame = line_of(frame);
  const auto top =
      std::find_first_of(of_frame.begin(), of_frame.end(), of_base.begin(), of_base.end());
  if (top == of_frame.end()) return {};
  Mount mount;
  mount.base_from_frame =
      inverse(first_pose(of_base, *top, mount.moving)) * first_pose(of_frame, *top, mount.moving);
  return mount;
}

}  // namespace mapbed
