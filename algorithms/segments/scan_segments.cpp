#include "algorithms/segments/scan_segments.h"

#include <algorithm>
#include <cmath>

namespace mapbed {
namespace {

constexpr double kSteep = 0.1;    // [m] by which ranges of neighbouring beams differ on a slant
constexpr double kOffLine = 0.1;  // of that, by which they may be off a line

// The end of a beam, and what past scans saw there.
struct End {
  std::size_t index = 0;  // of the eye's beams
  std::size_t beam = 0;   // of the scan
  Eigen::Vector2d point;  // [m] in the robot frame
  double range = 0.0;     // [m]
  double spacing = 0.0;   // [m] of neighbouring beams there
  SeenBefore before = SeenBefore::nothing;
};

// Whether neighbouring ends lie on a line that is seen aslant, along which 1 / range is linear.
bool are_on_a_slant(const End& a, const End& b, const End& c) {
  if (b.index != a.index + 1 || c.index != b.index + 1) return false;
  const bool is_steep = std::min(std::abs(a.range - b.range), std::abs(b.range - c.range)) > kSteep;
  const double expected = 2.0 / (1.0 / a.range + 1.0 / c.range);
  return is_steep && std::abs(b.range - expected) < kOffLine * std::abs(a.range - c.range);
}

// Beams of past scans that end on a wall aslant end far before or behind the point that is asked
// for: they did not see through.
void doubt_slants(std::vector<End>& ends) {
  std::vector<bool> is_slant(ends.size(), false);
  for (std::size_t i = 0; i + 2 < ends.size(); ++i) {
    if (!are_on_a_slant(ends[i], ends[i + 1], ends[i + 2])) continue;
    for (std::size_t k = i; k < i + 3; ++k) is_slant[k] = true;
  }
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (is_slant[i] && ends[i].before == SeenBefore::free) ends[i].before = SeenBefore::nothing;
  }
}

std::vector<End> ends_of(const ScanView& view, const ScanView::Eye& eye,
                         const Pose2& local_from_robot, const RecentScans& past,
                         const ScanSegmentOptions& options) {
  const LaserScan& scan = view.scan();
  const PastScans scans = past.past(scan.time);
  std::vector<End> ends;
  for (std::size_t i = 0; i < eye.size(); ++i) {
    const std::size_t beam = eye.beam(i);
    const double range = scan.ranges[beam];
    if (!scan.is_hit(beam) || range > options.max_range) continue;
    End end{i, beam, scan.point_on(beam, range), range, range * eye.step};
    end.before =
        scans.verdict(past.before(end.point, end.spacing, local_from_robot, options.radius));
    // Whoever walks to and fro there is not told from glass here.
    if (end.before == SeenBefore::mixed) end.before = SeenBefore::same;
    ends.push_back(end);
  }
  doubt_slants(ends);
  return ends;
}

// A beam that failed in between is none that saw through.
bool is_jump(const End& a, const End& b, const ScanSegmentOptions& options) {
  const double beams = static_cast<double>(b.index - a.index);
  return b.index - a.index > 2 ||
         (b.point - a.point).norm() > options.jump + beams * std::max(a.spacing, b.spacing);
}

bool both_stood_or_not(const End& a, const End& b) {
  return (a.before == SeenBefore::same) == (b.before == SeenBefore::same);
}

SeenBefore most_of(const std::vector<End>& ends, std::size_t first, std::size_t last) {
  if (ends[first].before == SeenBefore::same) return SeenBefore::same;  // then all of them are
  const auto free = std::count_if(ends.begin() + static_cast<std::ptrdiff_t>(first),
                                  ends.begin() + static_cast<std::ptrdiff_t>(last),
                                  [](const End& end) { return end.before == SeenBefore::free; });
  return 2 * static_cast<std::size_t>(free) >= last - first ? SeenBefore::free
                                                            : SeenBefore::nothing;
}

}  // namespace

std::vector<ScanSegment> segments_of(const ScanView& view, const Pose2& local_from_robot,
                                     const RecentScans& past, const ScanSegmentOptions& options) {
  std::vector<ScanSegment> segments;
  int piece = 0;
  for (const ScanView::Eye& eye : view.eyes()) {
    const std::vector<End> ends = ends_of(view, eye, local_from_robot, past, options);
    for (std::size_t first = 0, last = 0; first < ends.size(); first = last) {
      ScanSegment& segment = segments.emplace_back();
      if (first == 0 || is_jump(ends[first - 1], ends[first], options)) ++piece;
      segment.piece = piece;
      for (last = first; last < ends.size(); ++last) {
        if (last > first && (is_jump(ends[last - 1], ends[last], options) ||
                             !both_stood_or_not(ends[last - 1], ends[last]))) {
          break;
        }
        segment.beams.push_back(ends[last].beam);
        segment.box.extend(local_from_robot * ends[last].point);
      }
      segment.before = most_of(ends, first, last);
    }
  }
  return segments;
}

}  // namespace mapbed
