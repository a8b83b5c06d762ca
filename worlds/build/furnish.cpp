#include "worlds/build/furnish.h"

#include <cmath>

#include "core/geometry/angle.h"
#include "worlds/build/furniture.h"

namespace mapbed {
namespace {

constexpr double kHalfWall = 0.08;  // [m] and a finger's breadth
constexpr int kTries = 8;           // for a place for one piece

void place_desk(FurniturePlacer& placer, const World& world, const Eigen::AlignedBox2d& room,
                Rng& rng) {
  const double depth = rng.uniform(0.7, 0.85);
  const double width = rng.uniform(1.3, 1.8);
  for (int i = 0; i < kTries; ++i) {
    const Pose2 pose = pose_at_wall(room, kHalfWall + 0.04 + depth / 2, rng);
    if (!placer.place(desk(world, pose, width, depth))) continue;
    const double turn = kPi + rng.uniform(-0.6, 0.6);
    const Pose2 seat =
        pose * Pose2{depth / 2 + rng.uniform(0.3, 0.5), rng.uniform(-0.2, 0.2), turn};
    placer.place(office_chair(world, seat));
    return;
  }
}

template <class Make>
void place_at_wall(FurniturePlacer& placer, const Eigen::AlignedBox2d& room, double half_depth,
                   Rng& rng, Make make) {
  for (int i = 0; i < kTries; ++i) {
    if (placer.place(make(pose_at_wall(room, kHalfWall + 0.03 + half_depth, rng)))) return;
  }
}

void place_meeting_table(FurniturePlacer& placer, const World& world,
                         const Eigen::AlignedBox2d& room, Rng& rng) {
  const Eigen::Vector2d size = room.sizes();
  const bool along_x = size.x() > size.y();
  const double length = std::min(3.2, 0.5 * size.maxCoeff());
  for (int i = 0; i < kTries; ++i) {
    const Eigen::Vector2d middle =
        room.center() + Eigen::Vector2d(rng.uniform(-0.8, 0.8), rng.uniform(-0.8, 0.8));
    const Pose2 pose{middle.x(), middle.y(), along_x ? 0.0 : kPi / 2};
    if (!placer.place(table(world, pose, length, 1.1))) continue;
    for (double x = -length / 2 + 0.4; x < length / 2; x += 0.75) {
      for (const double side : {-1.0, 1.0}) {
        const Pose2 seat{x, side * rng.uniform(0.85, 1.0),
                         -side * kPi / 2 + rng.uniform(-0.3, 0.3)};
        placer.place(chair(world, pose * seat));
      }
    }
    return;
  }
}

}  // namespace

Pose2 pose_at_wall(const Eigen::AlignedBox2d& room, double from_wall, Rng& rng) {
  const double fraction = rng.uniform();
  const Eigen::Vector2d low = room.min();
  const Eigen::Vector2d high = room.max();
  const double x = low.x() + fraction * (high.x() - low.x());
  const double y = low.y() + fraction * (high.y() - low.y());
  switch (rng.index(4)) {
    case 0:
      return {x, low.y() + from_wall, kPi / 2};
    case 1:
      return {high.x() - from_wall, y, kPi};
    case 2:
      return {x, high.y() - from_wall, -kPi / 2};
    default:
      return {low.x() + from_wall, y, 0.0};
  }
}

void furnish_office_room(FurniturePlacer& placer, const World& world,
                         const Eigen::AlignedBox2d& room, bool meeting_room, double fullness,
                         Rng& rng) {
  if (fullness <= 0.0) return;
  if (meeting_room) place_meeting_table(placer, world, room, rng);
  const int pieces = static_cast<int>(std::lround(fullness * room.volume() / 4.0));
  for (int i = 0; i < pieces; ++i) {
    const double kind = rng.uniform();
    if (kind < 0.4 && !meeting_room) {
      place_desk(placer, world, room, rng);
    } else if (kind < 0.75) {
      const double width = rng.uniform(0.6, 1.2);
      const double height = rng.uniform() < 0.5 ? 0.8 : 1.9;
      place_at_wall(placer, room, 0.225, rng,
                    [&](const Pose2& pose) { return cabinet(world, pose, width, 0.45, height); });
    } else if (kind < 0.88) {
      place_at_wall(placer, room, 0.2, rng, [&](const Pose2& pose) { return bin(world, pose); });
    } else {
      place_at_wall(placer, room, 0.35, rng, [&](const Pose2& pose) { return plant(world, pose); });
    }
  }
}

}  // namespace mapbed
