#include "robots/robot.h"

#include <algorithm>
#include <cmath>

#include "core/config/config_node.h"
#include "core/data_path.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr double kSmallest = 0.01;  // [m] of a footprint; smaller bodies are none to the physics

void check_footprint(const SourceLocation& place, const RobotFootprint& footprint) {
  const bool is_box = footprint.length > 0.0 && footprint.width > 0.0;
  const bool half_a_box = (footprint.length > 0.0) != (footprint.width > 0.0);
  if (half_a_box || is_box == (footprint.radius > 0.0)) {
    throw InputError(place, "the footprint is neither a circle nor a box",
                     "give either radius, or length and width");
  }
  if (footprint.inner_radius() < kSmallest / 2.0) {
    throw InputError(place, "the footprint is narrower than 1 cm", "give the robot's own size");
  }
}

void check_drive(const SourceLocation& place, const Robot& robot) {
  if (robot.drive.kind == DriveKind::ackermann && robot.drive.wheel_base < kSmallest) {
    throw InputError(place, "a car without a wheel base cannot be steered",
                     "give drive.wheel_base, between its axles");
  }
  const OdometryModel& odometry = robot.odometry;
  if (odometry.errors == OdometryErrors::components &&
      (odometry.start_turn_bias != 0.0 || odometry.start_turn_per_meter != 0.0)) {
    throw InputError(place, "odometry with errors of components has no start turn",
                     "leave out odometry.start_turn_…, or say odometry.errors: turns");
  }
}

void refuse_old_key(const ConfigNode& node, const std::string& old_key, const std::string& key) {
  const ConfigNode* old = node.find(old_key);
  if (old != nullptr)
    throw InputError(old->place(), in_quotes(old_key) + " is now " + in_quotes(key));
}

// The model of a sensor's file, which `place` names.
void take_model(const std::string& file, const SourceLocation& place, MountedSensor& sensor) {
  sensor.file = with_whole_path(file, place);
  try {
    sensor.model = load_sensor(sensor.file);
  } catch (const InputError& error) {
    const std::string message = error.what();
    if (!message.starts_with("unknown sensor")) throw;
    throw InputError(place, message);
  }
}

// An entry of the robot's list of sensors: a sensor by name, where it is mounted, and what differs
// from the sensor's file.
MountedSensor mounted_sensor(const ConfigNode& entry) {
  refuse_old_key(entry, "height", "z");
  MountedSensor sensor;
  sensor.name = entry.at("name").text();
  const ConfigNode& file = entry.at("sensor");
  take_model(file.text(), file.place(), sensor);
  const std::string whole_path = sensor.file;
  read_options(entry, options_of(sensor));
  sensor.file = whole_path;
  check_sensor(sensor.model, entry.place());
  return sensor;
}

std::vector<MountedSensor> sensors_of(const ConfigNode& file) {
  std::vector<MountedSensor> sensors;
  refuse_old_key(file, "lasers", "sensors");
  const ConfigNode* list = file.find("sensors");
  if (list == nullptr) return sensors;
  for (const ConfigNode& entry : list->items()) {
    MountedSensor sensor = mounted_sensor(entry);
    for (const MountedSensor& other : sensors) {
      if (other.name != sensor.name) continue;
      throw InputError(entry.place(), "a second sensor is called " + in_quotes(sensor.name),
                       "give each sensor a name of its own");
    }
    sensors.push_back(std::move(sensor));
  }
  return sensors;
}

}  // namespace

double RobotFootprint::reach() const {
  return radius > 0.0 ? radius : std::hypot(length, width) / 2.0;
}

double RobotFootprint::inner_radius() const {
  return radius > 0.0 ? radius : std::min(length, width) / 2.0;
}

namespace {

// All sensors of one model, as `Mounted` has them.
template <class Mounted, class Model>
std::vector<Mounted> sensors_with(const Robot& robot) {
  std::vector<Mounted> result;
  for (const MountedSensor& sensor : robot.sensors) {
    const auto* model = std::get_if<Model>(&sensor.model);
    if (model != nullptr) result.push_back({sensor.robot_from_sensor, *model});
  }
  return result;
}

}  // namespace

std::vector<MountedLaser> lasers_of(const Robot& robot) {
  return sensors_with<MountedLaser, LaserModel>(robot);
}

std::vector<MountedAntenna> antennas_of(const Robot& robot) {
  return sensors_with<MountedAntenna, RfidModel>(robot);
}

Robot load_robot(const std::string& name_or_path) {
  const auto path = find_data_file("robot", "robots", name_or_path);
  Robot robot;
  robot.files = {input_file(path.string())};
  const ConfigNode file = load_config(path.string());
  robot.name = path.stem().string();
  if (const ConfigNode* source = file.find("source")) robot.source = source->text();
  // Before there are sensors, whose names are not keys of the file.
  read_options(file, options_of(robot));
  check_footprint(file.at("footprint").place(), robot.footprint);
  check_drive(file.place(), robot);
  robot.sensors = sensors_of(file);
  for (const MountedSensor& sensor : robot.sensors) {
    merge({input_file(sensor_file(sensor.file))}, robot.files);
  }
  file.check_all_used("the robot");
  return robot;
}

void exchange_sensors(Settings& settings, Robot& robot) {
  for (MountedSensor& sensor : robot.sensors) {
    std::erase_if(settings, [&](const Setting& setting) {
      if (setting.path != "robot." + sensor.name + ".sensor") return false;
      if (setting.text == sensor.file) return true;
      take_model(setting.text, setting.place, sensor);
      merge({input_file(sensor_file(sensor.file))}, robot.files);
      return true;
    });
  }
}

void check_robot(const Robot& robot, const SourceLocation& place) {
  check_footprint(place, robot.footprint);
  check_drive(place, robot);
  for (const MountedSensor& sensor : robot.sensors) check_sensor(sensor.model, place);
}

std::vector<std::string> robot_names() {
  return data_names("robots");
}

}  // namespace mapbed
