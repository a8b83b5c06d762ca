#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace mapbed {

// A tag within reach, before chance: power = direct - crossing + multipath.
struct IdealTag {
  std::int32_t tag = 0;        // index into the world's tags
  float power = 0.0F;          // [dBm] that it receives
  float direct = 0.0F;         // [dBm] on the straight way, were it free
  float crossing = 0.0F;       // [dB] that things in this way take
  float multipath = 0.0F;      // [dB] that the other ways add or take
  float phase = 0.0F;          // [rad] of its answer, in [0, 2 pi)
  bool is_reflection = false;  // the strongest way is not the straight one
};

// Everything about an inventory round that chance needs to know.
struct IdealRfid {
  double time = 0.0;                                      // [s] the round's own stamp
  std::uint64_t round = 0;                                // counts this antenna's rounds
  int antenna = 0;                                        // as RfidDetections counts
  Eigen::Vector2d place = Eigen::Vector2d::Zero();        // [m] of the antenna, in the plan
  std::vector<IdealTag> tags;                             // by index
  std::shared_ptr<const std::vector<std::string>> names;  // of all tags of the world
};

}  // namespace mapbed
