#include "algorithms/scan/level_lasers.h"

#include <cmath>

#include <fmt/format.h>

#include "core/geometry/angle.h"

namespace mapbed {

bool LevelLasers::take(const LaserScan& scan) {
  const Mount& mount = scan.robot_from_laser;
  if (mount.is_level()) return true;
  left_out_.try_emplace(scan.laser, std::acos(std::cos(mount.pitch) * std::cos(mount.roll)));
  return false;
}

std::vector<Remark> LevelLasers::remarks() const {
  std::vector<Remark> result;
  for (const auto& [laser, tilt] : left_out_) {
    result.push_back(
        {RemarkKind::tilted_laser,
         fmt::format(
             "laser {} is tilted by {:.4g} degrees: left out, as this method works in the plane",
             laser, degrees(tilt))});
  }
  return result;
}

}  // namespace mapbed
