#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/pose3.h"
#include "core/geometry/stamped.h"

namespace mapbed {

// The frames of a bag, as tf and tf_static tell them: each has one parent, from which it is seen at
// poses that may change.
class FrameTree {
 public:
  // Of a pose that is no pose: false, and nothing is added.
  bool add(const std::string& parent, const std::string& child, const Stamped<Pose3>& pose);

  bool knows(const std::string& frame) const;  // as child or as parent
  // The parent's poses of the frame, in the order in which they were added; null: it has none.
  const std::vector<Stamped<Pose3>>* poses_of(const std::string& frame) const;
  // The frames that are seen from it directly, in the order of their names.
  std::vector<std::string> children_of(const std::string& frame) const;

  struct Mount {
    Pose3 base_from_frame;
    std::string moving;  // a frame on the way that moves; the first pose was taken. Empty: none
  };
  // By the nearest frame that both hang on; none: the tree does not tell.
  std::optional<Mount> mount(const std::string& base, const std::string& frame) const;

  static constexpr std::size_t kPoseMemory =
      2 * sizeof(Stamped<Pose3>);  // [bytes] that add() takes

 private:
  struct Edge {
    std::string parent;
    std::vector<Stamped<Pose3>> poses;  // parent from child
    bool moves = false;
  };

  std::vector<std::string> line_of(const std::string& frame) const;  // itself, its parent, …
  Pose3 first_pose(const std::vector<std::string>& line, const std::string& top,
                   std::string& moving) const;

  std::map<std::string, Edge> edges_;  // by child
};

}  // namespace mapbed
