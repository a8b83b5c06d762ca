#include "algorithms/submaps/scan_extent.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

constexpr double kCoarsest = 0.06;  // [rad] beams farther apart know nothing of what is between

// The beams [first, first + count) of a scan.
struct Part {
  std::size_t first = 0, count = 0;
};

std::vector<Part> parts_of(const LaserScan& scan) {
  if (scan.parts.empty()) return {{0, scan.ranges.size()}};
  std::vector<Part> parts;
  std::size_t first = 0;
  for (const ScanPart& part : scan.parts) {
    parts.push_back({first, part.beams});
    first += part.beams;
  }
  return parts;
}

}  // namespace

ScanExtent::ScanExtent(const LaserScan& scan, double max_range, double no_return_range) {
  for (const Part& part : parts_of(scan)) {
    if (part.count < 2 || part.first + part.count > scan.ranges.size()) continue;
    const auto direction_of = [&](std::size_t beam) {
      const double range = scan.ranges[beam];
      const bool hit = scan.is_hit(beam) && range < max_range;
      const bool tells = range > 0.0 && (scan.is_hit(beam) || scan.max_range <= no_return_range);
      const double until = std::min({range, scan.max_range, max_range});
      return Direction{tells ? static_cast<float>(until) : 0.0F, hit};
    };
    Fan fan;
    if (scan.robot_from_beams.empty()) {
      fan.robot_from_laser = scan.robot_from_laser.planar;
      fan.first_bearing = scan.bearing(part.first);
      fan.bearing_step = scan.bearing_step;
      for (std::size_t n = 0; n < part.count; ++n) {
        fan.directions.push_back(direction_of(part.first + n));
      }
    } else {
      // As seen from the beam in the middle: their starts lie within centimetres of each other.
      const Pose2& first = scan.robot_from_beams[part.first];
      const Pose2& middle = scan.robot_from_beams[part.first + part.count / 2];
      double turned = 0.0;
      for (std::size_t n = 1; n < part.count; ++n) {
        turned += angle_difference(scan.robot_from_beams[part.first + n - 1].theta,
                                   scan.robot_from_beams[part.first + n].theta);
      }
      fan.robot_from_laser = {middle.x, middle.y, 0.0};
      fan.first_bearing = first.theta;
      fan.bearing_step = turned / static_cast<double>(part.count - 1);
      for (std::size_t n = 0; n < part.count; ++n) {
        fan.directions.push_back(direction_of(part.first + n));
      }
    }
    if (fan.bearing_step != 0.0 && std::abs(fan.bearing_step) <= kCoarsest) {
      fans_.push_back(std::move(fan));
    }
  }
}

Seen ScanExtent::seen_by(const Fan& fan, const Eigen::Vector2d& point_in_robot, double margin) {
  const Eigen::Vector2d point = inverse(fan.robot_from_laser) * point_in_robot;
  const double distance = point.norm();
  // Counted from the first beam on, in [0, 2 pi) the way the beams turn.
  double turned = std::atan2(point.y(), point.x()) - fan.first_bearing;
  if (fan.bearing_step < 0.0) turned = -turned;
  const double half_step = 0.5 * std::abs(fan.bearing_step);
  turned = std::fmod(turned, 2.0 * kPi);
  if (turned < -half_step) turned += 2.0 * kPi;
  if (turned >= 2.0 * kPi - half_step) turned -= 2.0 * kPi;
  const double beam = std::max(0.0, turned / std::abs(fan.bearing_step));
  const auto before = static_cast<std::size_t>(beam);
  const auto count = fan.directions.size();
  if (before >= count) return Seen::nothing;
  const Direction& a = fan.directions[before];
  const Direction& b = fan.directions[std::min(before + 1, count - 1)];
  if (a.range == 0.0F || b.range == 0.0F) return Seen::nothing;
  const double nearer = std::min(a.range, b.range), farther = std::max(a.range, b.range);
  if (distance < nearer - margin) return Seen::free;
  if (distance > farther + margin) return Seen::nothing;
  const bool ends_there = (a.hit && std::abs(distance - double{a.range}) <= margin) ||
                          (b.hit && std::abs(distance - double{b.range}) <= margin);
  return ends_there ? Seen::surface : Seen::nothing;
}

Seen ScanExtent::at(const Eigen::Vector2d& point_in_robot, double margin) const {
  Seen seen = Seen::nothing;
  for (const Fan& fan : fans_) {
    const Seen by_fan = seen_by(fan, point_in_robot, margin);
    if (by_fan == Seen::surface) return by_fan;
    if (by_fan == Seen::free) seen = by_fan;
  }
  return seen;
}

}  // namespace mapbed
