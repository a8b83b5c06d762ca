#include "robots/robot.h"

#include <algorithm>
#include <cmath>

#include "core/config/config_node.h"
#include "core/data_path.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

void check_footprint(const ConfigNode& node, const RobotFootprint& footprint) {
  const bool is_box = footprint.length > 0.0 && footprint.width > 0.0;
  const bool half_a_box = (footprint.length > 0.0) != (footprint.width > 0.0);
  if (half_a_box || is_box == (footprint.radius > 0.0)) {
    throw InputError(node.place(), "the footprint is neither a circle nor a box",
                     "give either radius, or length and width");
  }
}

void check_laser(const ConfigNode& file, const LaserModel& laser) {
  const double turn = laser.beams * laser.bearing_step;
  if (turn > 2.0 * 3.1416) {
    throw InputError(file.place(), "the beams cover more than a full turn",
                     "lower beams or bearing_step");
  }
  if (laser.noise.far_range < laser.noise.near_range) {
    throw InputError(file.place(), "noise.far_range is below noise.near_range",
                     "the error grows from near_range to far_range");
  }
  if (laser.mirror_rate > 0.0 && laser.scan_rate * laser.interlace > laser.mirror_rate) {
    throw InputError(file.place(), "sweeps come faster than the mirror turns",
                     "lower scan_rate, or raise mirror_rate (0: all beams at once)");
  }
}

LaserModel laser_of(const ConfigNode& file) {
  LaserModel laser;
  read_options(file, options_of(laser));
  check_laser(file, laser);
  return laser;
}

// An entry of the robot's list of lasers: a mount, a sensor by name, and what differs from it.
MountedLaser mounted_laser(const ConfigNode& entry) {
  MountedLaser laser;
  laser.name = entry.at("name").text();
  laser.sensor = entry.at("sensor").text();
  try {
    laser.model = load_laser(laser.sensor);
  } catch (const InputError& error) {
    const std::string message = error.what();
    if (!message.starts_with("unknown sensor")) throw;
    throw InputError(entry.at("sensor").place(), message);
  }
  const auto number = [&entry](const char* key, Unit unit, double otherwise) {
    const ConfigNode* node = entry.find(key);
    return node == nullptr ? otherwise : node->number(unit);
  };
  laser.robot_from_laser = {number("x", Unit::meter, 0.0), number("y", Unit::meter, 0.0),
                            number("heading", Unit::radian, 0.0)};
  laser.height = number("height", Unit::meter, laser.height);
  if (laser.height <= 0.0) {
    throw InputError(entry.at("height").place(), "the laser's height is not above the floor",
                     "give the height of the scan plane");
  }
  read_options(entry, options_of(laser.model));
  check_laser(entry, laser.model);
  return laser;
}

std::vector<MountedLaser> lasers_of(const ConfigNode& file) {
  std::vector<MountedLaser> lasers;
  const ConfigNode* list = file.find("lasers");
  if (list == nullptr) return lasers;
  for (const ConfigNode& entry : list->items()) {
    MountedLaser laser = mounted_laser(entry);
    for (const MountedLaser& other : lasers) {
      if (other.name != laser.name) continue;
      throw InputError(entry.place(), "a second laser is called '" + laser.name + "'",
                       "give each laser a name of its own");
    }
    lasers.push_back(std::move(laser));
  }
  return lasers;
}

}  // namespace

double RobotFootprint::reach() const {
  return radius > 0.0 ? radius : std::hypot(length, width) / 2.0;
}

double RobotFootprint::inner_radius() const {
  return radius > 0.0 ? radius : std::min(length, width) / 2.0;
}

LaserModel load_laser(const std::string& name_or_path) {
  const auto path = find_data_file("sensor", "robots/sensors", name_or_path);
  const ConfigNode file = load_config(path.string());
  const LaserModel laser = laser_of(file);
  file.check_all_used("the sensor");
  return laser;
}

Robot load_robot(const std::string& name_or_path) {
  const auto path = find_data_file("robot", "robots", name_or_path);
  const ConfigNode file = load_config(path.string());
  Robot robot;
  robot.name = path.stem().string();
  read_options(file,
               options_of(robot));  // before there are lasers, whose names are not keys of the file
  check_footprint(file.at("footprint"), robot.footprint);
  robot.lasers = lasers_of(file);
  file.check_all_used("the robot");
  return robot;
}

std::vector<std::string> robot_names() {
  return data_names("robots");
}

std::vector<std::string> sensor_names() {
  return data_names("robots/sensors");
}

}  // namespace mapbed
