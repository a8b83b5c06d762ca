#pragma once

#include <cmath>
#include <vector>

#include "core/geometry/angle.h"
#include "core/testing/test_room.h"

// People in tiny worlds, for tests.

namespace mapbed {

inline void add_leg(TestRoom& room, const Eigen::Vector2d& axis, double radius = 0.07) {
  constexpr int kSides = 12;
  const auto corner = [&](int k) -> Eigen::Vector2d {
    const double angle = 2.0 * kPi * k / kSides;
    return axis + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  };
  for (int i = 0; i < kSides; ++i) room.add({corner(i), corner(i + 1)});
}

// Both legs, beside each other across the line to the origin.
inline void add_person(TestRoom& room, const Eigen::Vector2d& position) {
  const Eigen::Vector2d away = position.normalized();
  const Eigen::Vector2d aside(-away.y(), away.x());
  add_leg(room, position + 0.12 * aside);
  add_leg(room, position - 0.12 * aside);
}

inline TestLaser round_laser() {
  return {.beams = 271,
          .first_bearing = -radians(135.0),
          .bearing_step = radians(1.0),
          .max_range = 20.0};
}

constexpr double kScanPeriod = 0.1;  // [s]

// Scans from the origin of a room of 12 m x 10 m with a column in it, while somebody goes along the
// positions, one a scan, and `hides` stands in front of him (may be no walls at all).
inline std::vector<LaserScan> scans_of_somebody(const std::vector<Eigen::Vector2d>& positions,
                                                const std::vector<Segment>& hides = {}) {
  std::vector<LaserScan> scans;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    TestRoom room = rectangular_room(12.0, 10.0);
    add_leg(room, {1.5, -3.0});
    for (const Segment& wall : hides) room.add(wall);
    if (std::isfinite(positions[k].x())) add_person(room, positions[k]);
    scans.push_back(scan_of(room, {}, round_laser(), 100.0 + kScanPeriod * static_cast<double>(k)));
  }
  return scans;
}

// Somebody who is not there.
inline Eigen::Vector2d nowhere() {
  return Eigen::Vector2d::Constant(std::nan(""));
}

// From one place to another at a speed [m/s].
inline void walk(std::vector<Eigen::Vector2d>& positions, const Eigen::Vector2d& from,
                 const Eigen::Vector2d& to, double speed = 1.0) {
  const int steps = static_cast<int>((to - from).norm() / (speed * kScanPeriod));
  for (int i = 0; i < steps; ++i) positions.push_back(from + (to - from) * i / steps);
}

}  // namespace mapbed
