#include "algorithms/people/front_end/scan_view.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

ScanView::Eye eye_of(const LaserScan& scan, std::size_t first, std::size_t beams) {
  ScanView::Eye eye;
  eye.first_beam = first;
  eye.bearings.reserve(beams);
  for (std::size_t i = first; i < first + beams; ++i) {
    const Pose2 beam = scan.robot_from_beams.empty()
                           ? Pose2{scan.robot_from_laser.planar.x, scan.robot_from_laser.planar.y,
                                   scan.robot_from_laser.planar.theta + scan.bearing(i)}
                           : scan.robot_from_beams[i];
    eye.origin += beam.position() / static_cast<double>(beams);
    eye.bearings.push_back(eye.bearings.empty()
                               ? beam.theta
                               : eye.bearings.back() +
                                     angle_difference(eye.bearings.back(), beam.theta));
  }
  if (beams < 2) return eye;
  if (eye.bearings.back() < eye.bearings.front()) {
    eye.is_reversed = true;
    std::reverse(eye.bearings.begin(), eye.bearings.end());
  }
  eye.step =
      (eye.bearings.back() - eye.bearings.front()) / static_cast<double>(eye.bearings.size() - 1);
  return eye;
}

}  // namespace

double ScanView::Eye::bearing_of(const Eigen::Vector2d& point_in_robot) const {
  const Eigen::Vector2d to = point_in_robot - origin;
  const double middle = 0.5 * (bearings.front() + bearings.back());
  return middle + angle_difference(middle, std::atan2(to.y(), to.x()));
}

std::pair<std::size_t, std::size_t> ScanView::Eye::within(double bearing, double aside) const {
  const auto first = std::lower_bound(bearings.begin(), bearings.end(), bearing - aside);
  const auto last = std::upper_bound(first, bearings.end(), bearing + aside);
  return {static_cast<std::size_t>(first - bearings.begin()),
          static_cast<std::size_t>(last - bearings.begin())};
}

ScanView::ScanView(LaserScan scan) : scan_(std::move(scan)) {
  scan_.remissions.clear();
  if (scan_.ranges.empty()) return;
  if (scan_.parts.empty()) {
    eyes_.push_back(eye_of(scan_, 0, scan_.ranges.size()));
    return;
  }
  std::size_t first = 0;
  for (const ScanPart& part : scan_.parts) {
    if (part.beams > 0) eyes_.push_back(eye_of(scan_, first, part.beams));
    first += part.beams;
  }
}

}  // namespace mapbed
