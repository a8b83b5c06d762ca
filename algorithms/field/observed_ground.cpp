#include "algorithms/field/observed_ground.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace mapbed {

ObservedGround::Outline ObservedGround::outline_of(const LaserScan& scan, double max_range,
                                                   const Pose2& map_from_robot) {
  const Pose2 map_from_laser = map_from_robot * scan.robot_from_laser.planar;
  const auto reach = [&](std::size_t beam) {
    return std::clamp(scan.ranges[beam], 0.0, std::min(scan.max_range, max_range));
  };
  const bool is_of_one_place = scan.robot_from_beams.empty();
  const double c = std::cos(map_from_laser.theta), s = std::sin(map_from_laser.theta);
  std::vector<Eigen::Vector2d> directions;  // of beams, in the laser's frame
  for (std::size_t beam = 0; is_of_one_place && beam < scan.ranges.size(); ++beam) {
    const double bearing = scan.bearing(beam);
    directions.emplace_back(std::cos(bearing), std::sin(bearing));
  }
  const auto at = [&](std::size_t beam, double range) -> Eigen::Vector2d {
    if (!is_of_one_place) return map_from_robot * scan.point_on(beam, range);
    const Eigen::Vector2d point = range * directions[beam];
    return {map_from_laser.x + c * point.x() - s * point.y(),
            map_from_laser.y + s * point.x() + c * point.y()};
  };
  Outline outline{map_from_laser.position()};
  outline.reserve(2 * scan.ranges.size() + 1);
  for (std::size_t beam = 1; beam < scan.ranges.size(); ++beam) {
    const double both = std::min(reach(beam - 1), reach(beam));
    outline.push_back(at(beam - 1, both));
    outline.push_back(at(beam, both));
  }
  return outline;
}

// Row by row between the edges; a full circle overlaps itself by nothing.
void ObservedGround::count(const Outline& outline, int sign) {
  double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
  for (const Eigen::Vector2d& corner : outline) {
    low = std::min(low, corner.y());
    high = std::max(high, corner.y());
  }
  const int first = static_cast<int>(std::ceil(low / kCell - 0.5));
  const int last = static_cast<int>(std::ceil(high / kCell - 0.5)) - 1;
  if (last < first) return;
  std::vector<std::vector<double>> crossings(static_cast<std::size_t>(last - first + 1));
  for (std::size_t i = 0; i < outline.size(); ++i) {
    Eigen::Vector2d a = outline[i] / kCell;
    Eigen::Vector2d b = outline[(i + 1) % outline.size()] / kCell;
    if (a.y() > b.y()) std::swap(a, b);
    const int from = static_cast<int>(std::ceil(a.y() - 0.5));
    const int to = static_cast<int>(std::ceil(b.y() - 0.5));  // not included
    for (int y = from; y < to; ++y) {
      const double share = (y + 0.5 - a.y()) / (b.y() - a.y());
      crossings[static_cast<std::size_t>(y - first)].push_back(a.x() + share * (b.x() - a.x()));
    }
  }
  TiledGrid<std::uint16_t>::Writer writer(scans_);
  for (int y = first; y <= last; ++y) {
    std::vector<double>& row = crossings[static_cast<std::size_t>(y - first)];
    std::sort(row.begin(), row.end());
    for (std::size_t i = 0; i + 1 < row.size(); i += 2) {
      const int end = static_cast<int>(std::ceil(row[i + 1] - 0.5));
      for (int x = static_cast<int>(std::ceil(row[i] - 0.5)); x < end; ++x) {
        std::uint16_t& scans = writer.at({x, y});
        scans = static_cast<std::uint16_t>(scans + sign);
      }
    }
  }
}

bool ObservedGround::knows_about(const Eigen::Vector2d& hit, const Eigen::Vector2d& laser,
                                 const LikelihoodField& map) const {
  return sees_both_sides(hit, map) || went_through(hit, laser, map);
}

bool ObservedGround::sees_both_sides(const Eigen::Vector2d& hit, const LikelihoodField& map) const {
  constexpr double kDiagonal = 0.70710678118654752 * kAway;
  const std::array<Eigen::Vector2d, 4> ways = {
      Eigen::Vector2d(kAway, 0.0), Eigen::Vector2d(0.0, kAway),
      Eigen::Vector2d(kDiagonal, kDiagonal), Eigen::Vector2d(kDiagonal, -kDiagonal)};
  const double nothing = double{map.outlier_log()};
  const auto known = [&](const Eigen::Vector2d& point) {
    return scans_[scans_.cell_of(point)] > 0 || map.log_at(point) > nothing;
  };
  return std::any_of(ways.begin(), ways.end(), [&](const Eigen::Vector2d& way) {
    return known(hit + way) && known(hit - way);
  });
}

// Back along the beam to the ground that was looked over: a surface ends that, and the hit does not
// lie on its line, as hits further along a wall do.
bool ObservedGround::went_through(const Eigen::Vector2d& hit, const Eigen::Vector2d& laser,
                                  const LikelihoodField& map) const {
  constexpr double kOffLine = 0.2;  // [m] more than a line through noisy points errs nearby
  const double length = (laser - hit).norm();
  if (length <= kCell) return false;
  const Eigen::Vector2d step = (laser - hit) * (kCell / length);
  Eigen::Vector2d at = hit;
  for (int left = static_cast<int>(length / kCell); left > 0; --left) {
    if (scans_[scans_.cell_of(at)] > 0) break;
    at += step;
  }
  const auto ends_at = [&](const Eigen::Vector2d& point) {
    const std::optional<LikelihoodField::Surface> surface = map.surface_at(point);
    if (!surface) return false;
    const Eigen::Vector2d off = hit - surface->point;
    const Eigen::Vector2d across = off - off.dot(surface->along) * surface->along;
    return across.norm() > kOffLine;
  };
  return ends_at(at) || ends_at(at - step);
}

}  // namespace mapbed
