#include "algorithms/lazy_association/submap_evidence.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "algorithms/scan/surface_points.h"
#include "core/check.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

constexpr double kOnSurface = 0.2;   // [m] across its line, a point is taken to lie on it
constexpr double kSamePlace = 0.04;  // [m] pairs that moved by less are not compared again
constexpr double kSameTurn = 0.01;   // [rad]
constexpr std::size_t kRemembered = 4;

}  // namespace

void SubmapEvidence::add(const Submap& submap) {
  Known known{.submap = submap};
  known.surfaces.add(submap.surface, {});
  const std::size_t count = std::min<std::size_t>(submap.surface.size(), kPoints);
  for (std::size_t i = 0; i < count; ++i) {
    known.points.push_back(submap.surface[i * submap.surface.size() / count].position);
  }
  known.robots_from_submap = robots_from(submap);
  for (const Pose2& pose : submap.path) {
    known.radius = std::max(known.radius, pose.position().norm());
  }
  for (const SurfacePoint& point : submap.surface) {
    known.radius = std::max(known.radius, point.position.norm());
  }
  known.submap.surface.clear();
  known_.push_back(std::move(known));
  compared_.emplace_back();
}

bool SubmapEvidence::is_on_surface(const Known& known, const Eigen::Vector2d& point) {
  const SurfaceMap::Nearest nearest = known.surfaces.nearest(point);
  if (!nearest.found) return false;
  Eigen::Vector2d off(double{nearest.off_x}, double{nearest.off_y});
  const Eigen::Vector2d along = tangent_of({double{nearest.doubled_x}, double{nearest.doubled_y}});
  off -= along * along.dot(off);
  return off.squaredNorm() <= kOnSurface * kOnSurface;
}

SubmapEvidence::Marks SubmapEvidence::compared(const Known& earlier, const Known& later,
                                               const Pose2& earlier_from_later) {
  Marks marks;
  const PointMotion to_earlier(earlier_from_later), to_later(inverse(earlier_from_later));
  for (std::size_t i = 0; i < later.points.size(); ++i) {
    const Eigen::Vector2d point = to_earlier * later.points[i];
    const std::uint64_t bit = std::uint64_t{1} << i;
    if (is_on_surface(earlier, point)) {
      marks.matched |= bit;
    } else if (seen_in(earlier.submap, earlier.robots_from_submap, point) != Seen::nothing) {
      marks.contradicted |= bit;
    }
  }
  for (const Eigen::Vector2d& point_in_earlier : earlier.points) {
    const Eigen::Vector2d point = to_later * point_in_earlier;
    if (!is_on_surface(later, point) &&
        seen_in(later.submap, later.robots_from_submap, point) == Seen::free) {
      ++marks.looked_through;
    }
  }
  return marks;
}

const SubmapEvidence::Marks& SubmapEvidence::marks_of(int earlier, int later,
                                                      const Pose2& earlier_from_later) {
  std::vector<std::vector<Compared>>& of_later = compared_[static_cast<std::size_t>(later)];
  if (of_later.size() <= static_cast<std::size_t>(earlier)) {
    of_later.resize(static_cast<std::size_t>(earlier) + 1);
  }
  std::vector<Compared>& before = of_later[static_cast<std::size_t>(earlier)];
  for (const Compared& compared : before) {
    if (std::abs(compared.earlier_from_later.x - earlier_from_later.x) > kSamePlace ||
        std::abs(compared.earlier_from_later.y - earlier_from_later.y) > kSamePlace) {
      continue;  // without a root
    }
    if (distance(compared.earlier_from_later, earlier_from_later) <= kSamePlace &&
        std::abs(angle_difference(compared.earlier_from_later.theta, earlier_from_later.theta)) <=
            kSameTurn) {
      return compared.marks;
    }
  }
  if (before.size() == kRemembered) before.erase(before.begin());
  before.push_back(
      {earlier_from_later, compared(known_[static_cast<std::size_t>(earlier)],
                                    known_[static_cast<std::size_t>(later)], earlier_from_later)});
  return before.back().marks;
}

double SubmapEvidence::log_likelihood(int submap, const std::vector<Pose2>& poses) {
  const auto index = static_cast<std::size_t>(submap);
  CHECK(index < poses.size() && index < known_.size());
  const Known& later = known_[index];
  std::uint64_t matched = 0, contradicted = 0;
  int looked_through = 0;
  for (int earlier = 0; earlier < submap; ++earlier) {
    const auto other = static_cast<std::size_t>(earlier);
    const Pose2 earlier_from_later = motion_between(poses[other], poses[index]);
    const double reach = known_[other].radius + later.radius;
    if (earlier_from_later.position().squaredNorm() > reach * reach) continue;
    const Marks& marks = marks_of(earlier, submap, earlier_from_later);
    matched |= marks.matched;
    contradicted |= marks.contradicted;
    looked_through = std::max(looked_through, marks.looked_through);
  }
  const int on_surface = std::popcount(matched);
  const int against = std::popcount(contradicted & ~matched);
  const int unseen = static_cast<int>(later.points.size()) - on_surface - against;
  return -options_.point_weight *
         (options_.unseen * unseen + options_.contradicted * (against + looked_through));
}

double SubmapEvidence::of_a_new_place(int submap, const std::vector<Pose2>& poses, int neighbours) {
  const auto index = static_cast<std::size_t>(submap);
  CHECK(index < poses.size() && index < known_.size());
  std::uint64_t matched = 0;
  for (int earlier = std::max(0, submap - neighbours); earlier < submap; ++earlier) {
    matched |= marks_of(earlier, submap,
                        motion_between(poses[static_cast<std::size_t>(earlier)], poses[index]))
                   .matched;
  }
  const int unseen = static_cast<int>(known_[index].points.size()) - std::popcount(matched);
  return -options_.point_weight * options_.unseen * unseen;
}

double SubmapEvidence::log_likelihood(const std::vector<Pose2>& poses) {
  double sum = 0.0;
  for (int submap = 0; submap < static_cast<int>(poses.size()); ++submap) {
    sum += log_likelihood(submap, poses);
  }
  return sum;
}

}  // namespace mapbed
