#include "algorithms/scan/surface_points.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"

namespace mapbed {
namespace {

// Neighbouring hits may belong to one line if they are nearer than this many arcs between two
// beams: walls seen at up to 84 degrees off their normal.
constexpr double kMaxArcs = 10.0;
constexpr double kLineReach = 0.2;  // [m] of the hits that make a line, to either side
constexpr double kLineFlatness =
    0.03;  // a line's sigma across it, as a fraction of that along it, at most

constexpr double kSameDirection = 0.985;  // cos(10 deg): at twice the angle, so within 5 degrees

// Of the line through the points about each point of a run, at twice the angle; zero where there is
// none.
std::vector<Eigen::Vector2d> doubled_directions(const std::vector<Eigen::Vector2d>& run,
                                                double max_gap) {
  std::vector<Eigen::Vector2d> result(run.size(), Eigen::Vector2d::Zero());
  std::size_t first = 0, last = 0;  // the points within reach are [first, last)
  for (std::size_t i = 0; i < run.size(); ++i) {
    while ((run[i] - run[first]).norm() > kLineReach && first < i) ++first;
    last = std::max(last, i + 1);
    while (last < run.size() && (run[last] - run[i]).norm() <= kLineReach) ++last;
    // At long range the next hits are farther than the reach: one to either side always counts.
    std::size_t from = i > 0 ? std::min(first, i - 1) : first;
    std::size_t to = std::max(last, std::min(run.size(), i + 2));
    // Where hits lie far apart, the last one of a run does not tell where the surface ends: the
    // line goes on to it.
    const bool end_of_sparse_run =
        to - from == 2 && run.size() >= 3 && (run[from + 1] - run[from]).norm() > max_gap;
    if (end_of_sparse_run) (i == 0 ? ++to : --from);
    if (to - from < 3) continue;
    const auto count = static_cast<double>(to - from);
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (std::size_t k = from; k < to; ++k) mean += run[k] / count;
    double xx = 0.0, xy = 0.0, yy = 0.0;
    for (std::size_t k = from; k < to; ++k) {
      const Eigen::Vector2d d = run[k] - mean;
      xx += d.x() * d.x();
      xy += d.x() * d.y();
      yy += d.y() * d.y();
    }
    // The covariance's larger and smaller principal value are (xx + yy ± split) / 2, along half the
    // angle of (xx - yy, 2 xy).
    const Eigen::Vector2d doubled(xx - yy, 2.0 * xy);
    const double split = doubled.norm();
    if (xx + yy - split <= kLineFlatness * (xx + yy + split)) result[i] = doubled / split;
  }
  return result;
}

// visit(hits, number of the first one's beam) for hits that follow each other near enough for a
// line.
template <class Visitor>
void for_each_run(const LaserScan& scan, double max_range, double max_gap, Visitor&& visit) {
  std::vector<Eigen::Vector2d> run;
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    const double range = scan.ranges[beam];
    const bool is_hit = scan.is_hit(beam) && range < max_range;
    const Eigen::Vector2d point = is_hit ? scan.point_on(beam, range) : Eigen::Vector2d::Zero();
    const double reach = std::max(max_gap, kMaxArcs * range * std::abs(scan.bearing_step));
    if (!run.empty() && (!is_hit || (point - run.back()).norm() > reach)) {
      visit(run, beam - run.size());
      run.clear();
    }
    if (is_hit) run.push_back(point);
  }
  if (!run.empty()) visit(run, scan.ranges.size() - run.size());
}

// Whether the lines through a hit and the one before it both lie along the way between them.
bool are_of_one_wall(const std::vector<Eigen::Vector2d>& run,
                     const std::vector<Eigen::Vector2d>& lines, std::size_t i) {
  const Eigen::Vector2d way = run[i] - run[i - 1];
  const Eigen::Vector2d doubled(way.x() * way.x() - way.y() * way.y(), 2.0 * way.x() * way.y());
  const double least = kSameDirection * doubled.norm();
  return lines[i - 1].dot(doubled) > least && lines[i].dot(doubled) > least;
}

}  // namespace

Eigen::Vector2d tangent_of(const Eigen::Vector2d& mean_doubled) {
  constexpr double kMinAgreement = 0.5;
  const double agreement = mean_doubled.norm();
  if (agreement < kMinAgreement) return Eigen::Vector2d::Zero();
  const double c = mean_doubled.x() / agreement;
  return {std::sqrt(0.5 * (1.0 + c)),
          std::copysign(std::sqrt(std::max(0.0, 0.5 * (1.0 - c))), mean_doubled.y())};
}

std::vector<SurfacePoint> transformed(const std::vector<SurfacePoint>& points_in_b,
                                      const Pose2& a_from_b) {
  const double c = std::cos(a_from_b.theta), s = std::sin(a_from_b.theta);
  const double c2 = c * c - s * s, s2 = 2.0 * c * s;
  std::vector<SurfacePoint> points_in_a;
  points_in_a.reserve(points_in_b.size());
  for (const SurfacePoint& point : points_in_b) {
    const Eigen::Vector2d& p = point.position;
    const Eigen::Vector2d& d = point.doubled;
    points_in_a.push_back({{a_from_b.x + c * p.x() - s * p.y(), a_from_b.y + s * p.x() + c * p.y()},
                           {c2 * d.x() - s2 * d.y(), s2 * d.x() + c2 * d.y()}});
  }
  return points_in_a;
}

std::vector<SurfacePoint> surface_points(const LaserScan& scan, double max_range, double max_gap,
                                         double spacing) {
  CHECK(spacing > 0.0);
  std::vector<SurfacePoint> points;
  points.reserve(2 * scan.ranges.size());
  for_each_run(scan, max_range, max_gap, [&](const std::vector<Eigen::Vector2d>& run, std::size_t) {
    const std::vector<Eigen::Vector2d> lines = doubled_directions(run, max_gap);
    for (std::size_t i = 0; i < run.size(); ++i) {
      const double gap = i > 0 ? (run[i] - run[i - 1]).norm() : 0.0;
      const bool filled = i > 0 && (gap <= max_gap || are_of_one_wall(run, lines, i));
      const int pieces = filled ? static_cast<int>(gap / spacing) + 1 : 1;
      for (int k = 1; k < pieces; ++k) {
        points.push_back(
            {run[i - 1] + (run[i] - run[i - 1]) * k / pieces, 0.5 * (lines[i - 1] + lines[i])});
      }
      points.push_back({run[i], lines[i]});
    }
  });
  return points;
}

std::vector<Eigen::Vector2d> lines_at_beams(const LaserScan& scan, double max_range,
                                            double max_gap) {
  std::vector<Eigen::Vector2d> doubled(scan.ranges.size(), Eigen::Vector2d::Zero());
  for_each_run(
      scan, max_range, max_gap, [&](const std::vector<Eigen::Vector2d>& run, std::size_t first) {
        const std::vector<Eigen::Vector2d> lines = doubled_directions(run, max_gap);
        std::copy(lines.begin(), lines.end(), doubled.begin() + static_cast<std::ptrdiff_t>(first));
      });
  return doubled;
}

}  // namespace mapbed
