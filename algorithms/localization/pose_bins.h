#pragma once

#include <compare>
#include <cstddef>
#include <span>
#include <vector>

#include "core/config/option.h"
#include "core/geometry/pose2.h"

namespace mapbed {

// The space of poses cut into boxes, by which particles are counted and gathered.
struct PoseBinOptions {
  double side = 0.5;  // [m]
  int turns = 24;     // of the full circle
};

template <class Visitor>
void visit_fields(PoseBinOptions& o, Visitor&& visit) {
  visit("side", o.side, Unit::meter, between(0.01, 100.0), "of a box of poses");
  visit("turns", o.turns, between(4, 360), "boxes that the full circle is cut into");
}

struct PoseBin {
  int x = 0, y = 0, turn = 0;
  friend auto operator<=>(const PoseBin&, const PoseBin&) = default;
};

PoseBin bin_of(const Pose2& pose, const PoseBinOptions& options);

// How many boxes hold a pose.
std::size_t occupied_bins(std::span<const Pose2> poses, const PoseBinOptions& options);

// For each pose the number of the group that it belongs to, from 0: poses whose boxes touch each
// other, at corners too, are of one.
std::vector<std::size_t> touching_groups(std::span<const Pose2> poses,
                                         const PoseBinOptions& options);

}  // namespace mapbed
