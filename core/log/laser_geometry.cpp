#include "core/log/laser_geometry.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
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

using Scans = std::vector<const LaserScan*>;

// How often the most frequent value comes up, and the next one; of several the largest is the
// first.
struct Frequent {
  double value = 0.0;
  std::ptrdiff_t most = 0;
  std::ptrdiff_t second = 0;
};

Frequent most_frequent(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  Frequent result;
  for (auto run = values.begin(); run != values.end();) {
    const auto end = std::upper_bound(run, values.end(), *run);
    const std::ptrdiff_t count = end - run;
    if (count >= result.most) {
      result = {*run, count, result.most};
    } else {
      result.second = std::max(result.second, count);
    }
    run = end;
  }
  return result;
}

std::vector<double> readings_from(const Scans& scans, double least) {
  std::vector<double> readings;
  for (const LaserScan* scan : scans)
    for (const double r : scan->ranges)
      if (r >= least && std::isfinite(r)) readings.push_back(r);
  return readings;
}

// Whether a reading above half of `top` and below `end` comes up more often than that. Only values
// that share their bin with so many can, and those alone are sorted.
bool comes_up_more_often(const Scans& scans, double top, double end, std::ptrdiff_t than) {
  constexpr std::size_t kBins = 1 << 16;
  const double begin = 0.5 * top;
  const double per_bin = static_cast<double>(kBins - 1) / (end - begin);
  const auto bin_of = [&](double r) { return static_cast<std::size_t>((r - begin) * per_bin); };
  std::vector<std::ptrdiff_t> counts(kBins, 0);
  for (const LaserScan* scan : scans)
    for (const double r : scan->ranges)
      if (r > begin && r < end) ++counts[bin_of(r)];
  std::vector<double> readings;
  for (const LaserScan* scan : scans)
    for (const double r : scan->ranges)
      if (r > begin && r < end && counts[bin_of(r)] > than) readings.push_back(r);
  return most_frequent(std::move(readings)).most > than;
}

bool has_infinite_readings(const Scans& scans) {
  return std::any_of(scans.begin(), scans.end(), [](const LaserScan* scan) {
    return std::any_of(scan->ranges.begin(), scan->ranges.end(),
                       [](double r) { return std::isinf(r); });
  });
}

// A pile of equal readings at the upper end of the scale.
std::optional<double> pile_at_the_top(const Scans& scans, double top) {
  if (!(top > 0.0)) return std::nullopt;
  const double end = 0.99 * top;
  const Frequent pile = most_frequent(readings_from(scans, end));
  const std::ptrdiff_t others = pile.most / 10;
  if (others == 0 || pile.second > others) return std::nullopt;
  if (comes_up_more_often(scans, top, end, others)) return std::nullopt;
  return pile.value;
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
  if (stated > 0.0 && has_infinite_readings(scans)) return stated;
  double top = 0.0;
  for (const LaserScan* scan : scans)
    for (const double r : scan->ranges)
      if (std::isfinite(r)) top = std::max(top, r);

  for (const double code : {81.83, 8.183, 32.759}) {
    const double last = code + (code > 80.0 ? 0.08 : 0.008);
    if (top >= code - 1e-5 && top <= last + 1e-5)
      return stated > 0.0 ? std::min(code, stated) : code;
  }

  if (const auto pile = pile_at_the_top(scans, top))
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
