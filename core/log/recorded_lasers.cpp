#include "core/log/recorded_lasers.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "core/geometry/angle.h"
#include "core/log/laser_geometry.h"
#include "core/log/log_file.h"

namespace mapbed {
namespace {

// What the scans of one laser need, worked out once.
struct Laser {
  std::map<std::size_t, long> scans_of_beams;
  std::size_t usual_beams = 0;
  bool has_open = false;    // lines that do not state their bearings
  bool has_stated = false;  // lines that do
  BearingsInLog usual;
  std::map<std::size_t, std::optional<Bearings>> open;  // by number of beams
};

using Lasers = std::map<int, Laser>;

Lasers lasers_of(const RecordedLog& log) {
  Lasers lasers;
  for (const Measurement& m : log.measurements) {
    const auto* scan = std::get_if<LaserScan>(&m);
    if (scan == nullptr) continue;
    Laser& laser = lasers[scan->laser];
    ++laser.scans_of_beams[scan->ranges.size()];
    (scan->bearing_step == 0.0 ? laser.has_open : laser.has_stated) = true;
  }
  for (auto& [number, laser] : lasers) {
    const auto most =
        std::max_element(laser.scans_of_beams.begin(), laser.scans_of_beams.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    laser.usual_beams = most->first;
  }
  return lasers;
}

std::optional<Bearings> open_bearings(const Laser& laser, std::size_t beams,
                                      const StatedBearings& stated, const LogOptions& options) {
  if (beams == laser.usual_beams) return laser.usual.bearings;
  if (laser.usual.bearings && options.field_of_view == 0.0) {
    const auto near = bearings_of_neighbour(beams, *laser.usual.bearings, laser.usual_beams);
    if (near) return near;
  }
  return bearings_of(beams, stated, options).bearings;
}

void complete_open(Laser& laser, const StatedBearings& stated, const LogOptions& options) {
  laser.usual = bearings_of(laser.usual_beams, stated, options);
  for (const auto& [beams, count] : laser.scans_of_beams)
    laser.open[beams] = open_bearings(laser, beams, stated, options);
}

// False: nobody knows where this scan's beams point.
bool complete(LaserScan& scan, const Laser& laser, const RecordedLog& log,
              const LogOptions& options) {
  const auto& mount = scan.laser == 1 ? options.robot_from_rear_laser : options.robot_from_laser;
  if (std::isnan(scan.robot_from_laser.planar.x) || (scan.laser <= 1 && !mount.empty()))
    scan.robot_from_laser.planar = mount_of(scan.laser, log, options);
  Bearings bearings{scan.first_bearing, scan.bearing_step};
  if (bearings.step != 0.0) {
    bearings = replaced_bearings(bearings, scan.ranges.size(), options);
  } else {
    const auto& open = laser.open.at(scan.ranges.size());
    if (!open) return false;
    bearings = *open;
  }
  scan.first_bearing = bearings.first;
  scan.bearing_step = bearings.step;
  return true;
}

std::string source_of_lines(const LogOptions& options) {
  const std::string names = names_of_bearing_options(options);
  return names.empty() ? "its lines" : names + ", else its lines";
}

void list(RecordedLog& log, const Lasers& lasers, const LogOptions& options,
          const std::map<int, Bearings>& in_lines) {
  std::set<int> listed;
  for (const Measurement& m : log.measurements) {
    const auto* scan = std::get_if<LaserScan>(&m);
    if (scan == nullptr || listed.contains(scan->laser)) continue;
    const Laser& laser = lasers.at(scan->laser);
    if (scan->ranges.size() != laser.usual_beams) continue;
    listed.insert(scan->laser);
    RecordedLaser entry{scan->laser,
                        laser.usual_beams,
                        {scan->first_bearing, scan->bearing_step},
                        scan->robot_from_laser.planar,
                        source_of_lines(options)};
    if (laser.has_open) {
      entry.source = laser.usual.source;
      if (!laser.has_stated) entry.candidates = laser.usual.candidates;
    } else if (const auto other = in_lines.find(scan->laser); other != in_lines.end()) {
      entry.candidates = {replaced_bearings(other->second, laser.usual_beams, options)};
      std::erase(entry.candidates, entry.bearings);
    }
    log.lasers.push_back(std::move(entry));
  }
  std::sort(log.lasers.begin(), log.lasers.end(),
            [](const auto& a, const auto& b) { return a.laser < b.laser; });
}

}  // namespace

std::string name_of_laser(int laser) {
  if (laser > 1) return fmt::format("laser {}", laser + 1);
  return laser == 1 ? "rear laser" : "front laser";
}

std::string to_string(const RecordedLaser& laser) {
  const Pose2& mount = laser.robot_from_laser;
  return fmt::format("{}: {} beams, {} ({}), at ({:.4g} m, {:.4g} m, {:.4g} deg)",
                     name_of_laser(laser.laser), laser.beams, to_string(laser.bearings),
                     laser.source, mount.x, mount.y, degrees(mount.theta));
}

void set_bearings(RecordedLog& log, RecordedLaser& laser, const Bearings& bearings,
                  const std::string& source) {
  for (Measurement& m : log.measurements) {
    auto* scan = std::get_if<LaserScan>(&m);
    if (scan == nullptr || scan->laser != laser.laser) continue;
    const auto own = scan->ranges.size() == laser.beams
                         ? bearings
                         : bearings_of_neighbour(scan->ranges.size(), bearings, laser.beams);
    if (!own) continue;
    scan->first_bearing = own->first;
    scan->bearing_step = own->step;
  }
  laser.bearings = bearings;
  laser.source = source;
}

CompletedLasers complete_lasers(RecordedLog& log, const LogOptions& options,
                                const std::map<int, Bearings>& in_lines) {
  Lasers lasers = lasers_of(log);
  CompletedLasers result;
  for (auto& [number, laser] : lasers) {
    if (!laser.has_open) continue;
    complete_open(laser, stated_bearings(log, number), options);
    if (laser.usual.note.empty()) continue;
    const std::string name = parameter_names_of(number).bearings;
    const bool has_field = log.parameters.contains(name + "fov");
    result.notes_of_parameters[name + (has_field ? "fov" : "resolution")] = laser.usual.note;
  }
  std::erase_if(log.measurements, [&](Measurement& m) {
    auto* scan = std::get_if<LaserScan>(&m);
    if (scan == nullptr || complete(*scan, lasers.at(scan->laser), log, options)) return false;
    ++result.unknown[scan->ranges.size()];
    return true;
  });
  list(log, lasers, options, in_lines);
  return result;
}

}  // namespace mapbed
