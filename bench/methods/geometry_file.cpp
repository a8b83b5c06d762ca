#include "bench/methods/geometry_file.h"

#include <map>

#include <nlohmann/json.hpp>

namespace mapbed {

std::string geometry_json(const SensorLog& log) {
  std::map<int, const LaserScan*> first;
  for (const Measurement& measurement : log) {
    if (const auto* scan = std::get_if<LaserScan>(&measurement)) {
      first.try_emplace(scan->laser, scan);
    }
  }
  nlohmann::ordered_json json{{"units", "m, rad, s"}, {"lasers", nlohmann::ordered_json::array()}};
  for (const auto& [laser, scan] : first) {
    const Mount& mount = scan->robot_from_laser;
    json["lasers"].push_back({{"laser", laser},
                              {"x", mount.planar.x},
                              {"y", mount.planar.y},
                              {"theta", mount.planar.theta},
                              {"z", mount.z},
                              {"pitch", mount.pitch},
                              {"roll", mount.roll},
                              {"beams", scan->ranges.size()},
                              {"first_bearing", scan->first_bearing},
                              {"bearing_step", scan->bearing_step},
                              {"beam_period", scan->beam_period},
                              {"max_range", scan->max_range}});
  }
  return json.dump(2) + "\n";
}

}  // namespace mapbed
