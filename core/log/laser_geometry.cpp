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

// In degrees; 0: no laser that we know.
double usual_step(std::size_t beams) {
  switch (beams) {
    case 180:
    case 181:
      return 1.0;
    case 360:
    case 361:
    case 540:
    case 541:
      return 0.5;
    case 401:
    case 720:
    case 721:
    case 1081:
      return 0.25;
    case 681:
    case 682:
      return 360.0 / 1024.0;
    default:
      return 0.0;
  }
}

// An even number of beams is one cut off an odd one: 180 of 181.
double usual_first(std::size_t beams, double step) {
  return -0.5 * step * static_cast<double>(beams % 2 == 0 ? beams : beams - 1);
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

std::optional<Bearings> bearings_of(std::size_t beams, int laser, const RecordedLog& log,
                                    const LogOptions& options) {
  if (beams < 2) return std::nullopt;
  const double gaps = static_cast<double>(beams - 1);
  const std::string prefix = parameter_names_of(laser).bearings;
  double step = radians(usual_step(beams));
  if (const auto stated = parameter(log, prefix + "resolution");
      stated && *stated > 0.0 && *stated * gaps <= 360.0)
    step = radians(*stated);
  double first = usual_first(beams, step);
  if (const auto stated = parameter(log, prefix + "fov");
      stated && *stated > 0.0 && *stated <= 360.0) {
    if (step == 0.0) step = radians(*stated) / gaps;
    first = -0.5 * radians(*stated);
  }
  if (options.bearing_step != 0.0) {
    step = options.bearing_step;
    first = -0.5 * step * gaps;
  }
  if (options.field_of_view > 0.0) {
    if (options.bearing_step == 0.0) step = options.field_of_view / gaps;
    first = -0.5 * options.field_of_view;
  }
  if (!options.first_bearing.empty()) first = options.first_bearing[0];
  if (step == 0.0) return std::nullopt;
  return Bearings{first, step};
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

void replace_stated_bearings(LaserScan& scan, const LogOptions& options) {
  if (options.field_of_view > 0.0) {
    scan.first_bearing = -0.5 * options.field_of_view;
    if (scan.ranges.size() > 1)
      scan.bearing_step = options.field_of_view / static_cast<double>(scan.ranges.size() - 1);
  }
  if (options.bearing_step != 0.0) scan.bearing_step = options.bearing_step;
  if (!options.first_bearing.empty()) scan.first_bearing = options.first_bearing[0];
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
