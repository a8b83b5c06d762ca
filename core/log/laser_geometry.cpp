#include "core/log/laser_geometry.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <variant>

#include "core/file/tokens.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

std::optional<double> parameter(const RecordedLog& log, const std::string& name) {
  const auto found = log.parameters.find(name);
  if (found == log.parameters.end()) return std::nullopt;
  Tokens tokens(found->second);
  const double value = tokens.number();
  if (!tokens.ok() || !std::isfinite(value)) return std::nullopt;
  return value;
}

double stated_max_range(const RecordedLog& log, int laser) {
  const LaserParameterNames names = parameter_names_of(laser);
  for (const std::string& name : {names.max_range, names.bearings + "max_range"}) {
    const auto found = log.parameters.find(name);
    if (found == log.parameters.end()) continue;
    double value = 0.0;
    if (parse_number(found->second, value) && value > 0.0 && value <= kAbsurdRange) return value;
  }
  return 0.0;
}

// A pile of equal readings at the upper end of the scale.
std::optional<double> pile_at_the_top(std::vector<double>& upper_half) {
  if (upper_half.empty()) return std::nullopt;
  std::sort(upper_half.begin(), upper_half.end());
  double best = 0.0;
  std::ptrdiff_t most = 0;
  std::ptrdiff_t second = 0;
  for (auto run = upper_half.begin(); run != upper_half.end();) {
    const auto end = std::upper_bound(run, upper_half.end(), *run);
    const std::ptrdiff_t count = end - run;
    if (count >= most) {
      second = most;
      most = count;
      best = *run;
    } else {
      second = std::max(second, count);
    }
    run = end;
  }
  const bool at_the_top = best >= 0.99 * upper_half.back();
  return at_the_top && most >= 10 && most >= 10 * second ? std::optional(best) : std::nullopt;
}

}  // namespace

LaserParameterNames parameter_names_of(int laser) {
  const std::string number = std::to_string(laser + 1);
  if (laser > 1)
    return {"robot_laser" + number + "_", "laser_laser" + number + "_",
            "robot_laser" + number + "_max"};
  const std::string side = laser == 1 ? "rear" : "front";
  return {"robot_" + side + "laser_", "laser_" + side + "_laser_", "robot_" + side + "_laser_max"};
}

StatedBearings stated_bearings(const RecordedLog& log, int laser) {
  const std::string prefix = parameter_names_of(laser).bearings;
  StatedBearings stated{parameter(log, prefix + "resolution"), parameter(log, prefix + "fov"),
                        parameter(log, prefix + "first_bearing")};
  for (auto* value : {&stated.resolution, &stated.field_of_view})
    if (*value && !(**value > 0.0)) value->reset();
  if (stated.first) stated.first = radians(*stated.first);
  return stated;
}

Pose2 mount_of(int laser, const RecordedLog& log, const LogOptions& options) {
  const auto& given = laser == 1 ? options.robot_from_rear_laser : options.robot_from_laser;
  if (laser <= 1 && !given.empty()) return {given[0], given[1], normalized_angle(given[2])};
  const std::string prefix = parameter_names_of(laser).mount;
  Pose2 mount;
  mount.x = parameter(log, prefix + "offset").value_or(0.0);
  mount.y = parameter(log, prefix + "side_offset").value_or(0.0);
  mount.theta = parameter(log, prefix + "angular_offset").value_or(0.0);
  // CARMEN states a rear laser's distance behind the centre as a negative offset.
  if (laser == 1) mount.theta += kPi;
  mount.theta = normalized_angle(mount.theta);
  return mount;
}

double max_range_of(const std::vector<const LaserScan*>& scans, double stated) {
  double top = 0.0;
  for (const LaserScan* scan : scans)
    for (const double r : scan->ranges)
      if (std::isfinite(r)) top = std::max(top, r);

  for (const double code : {81.83, 8.183, 32.759}) {
    const double last = code + (code > 80.0 ? 0.08 : 0.008);
    if (top >= code - 1e-5 && top <= last + 1e-5)
      return stated > 0.0 ? std::min(code, stated) : code;
  }

  std::vector<double> upper_half;
  for (const LaserScan* scan : scans)
    for (const double r : scan->ranges)
      if (std::isfinite(r) && r > 0.5 * top) upper_half.push_back(r);
  if (const auto pile = pile_at_the_top(upper_half))
    return stated > 0.0 ? std::min(*pile, stated) : *pile;
  if (stated > 0.0) return stated;
  for (const double usual : {8.0, 16.0, 30.0, 50.0, 81.83})
    if (top < usual) return usual;
  return std::nextafter(top, INFINITY);
}

void complete_max_range(RecordedLog& log, const LogOptions& options) {
  std::map<int, std::vector<const LaserScan*>> scans_of;
  for (const Measurement& m : log.measurements)
    if (const auto* scan = std::get_if<LaserScan>(&m)) scans_of[scan->laser].push_back(scan);
  std::map<int, double> max_of;
  for (const auto& [laser, scans] : scans_of) {
    double stated = scans.front()->max_range;
    for (const LaserScan* scan : scans) stated = std::max(stated, scan->max_range);
    if (stated == 0.0) stated = stated_max_range(log, laser);
    max_of[laser] = options.max_range > 0.0 ? options.max_range : max_range_of(scans, stated);
  }
  for (Measurement& m : log.measurements) {
    auto* scan = std::get_if<LaserScan>(&m);
    if (scan == nullptr) continue;
    scan->max_range = max_of[scan->laser];
    for (double& r : scan->ranges)
      if (std::isinf(r)) r = scan->max_range;
  }
}

}  // namespace mapbed
