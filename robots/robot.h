#pragma once

#include <string>
#include <vector>

#include "core/config/option.h"
#include "core/config/settings.h"
#include "core/file/input_file.h"
#include "core/sensor/mount.h"
#include "robots/drive_model.h"
#include "robots/odometry_model.h"
#include "robots/sensor_model.h"

namespace mapbed {

// The robot's outline seen from above, about the robot's origin.
struct RobotFootprint {
  double radius = 0.0;  // [m] a circle; 0: a box
  double length = 0.0;  // [m] of the box, along x
  double width = 0.0;   // [m] of the box, along y

  double reach() const;         // [m] of the circle around it
  double inner_radius() const;  // [m] of the largest circle in it
};

// A sensor on the robot.
struct MountedSensor {
  std::string name;  // "front"
  std::string file;  // the sensor file's name, "sick_lms200", or its path from the root
  Mount robot_from_sensor{.planar = {}, .z = 0.4};
  SensorModel model;
};

// What drives: a data file in robots/, sensors by name from robots/sensors/.
struct Robot {
  std::string name;
  std::string about;
  std::string source;   // where the values are from; no option
  double mass = 1.0;    // [kg]
  double height = 1.0;  // [m]
  RobotFootprint footprint;
  DriveModel drive;
  OdometryModel odometry;
  std::vector<MountedSensor> sensors;  // in the order of the robot's file
  InputFiles files;                    // its own and those of its sensors
};

// A laser of a robot, taken out of its sensors.
struct MountedLaser {
  Mount robot_from_laser{.planar = {}, .z = 0.4};
  LaserModel model;
};
// In the order of the robot's file, as LaserScan::laser counts them: 0 front, 1 rear, …
std::vector<MountedLaser> lasers_of(const Robot& robot);

// An antenna of a robot's RFID reader, likewise.
struct MountedAntenna {
  Mount robot_from_antenna{.planar = {}, .z = 0.4};
  RfidModel model;
};
// In the order of the robot's file, as RfidDetections::antenna counts them.
std::vector<MountedAntenna> antennas_of(const Robot& robot);

template <class Visitor>
void visit_fields(RobotFootprint& o, Visitor&& visit) {
  visit("radius", o.radius, Unit::meter, between(0.0, 100.0), "of a round robot; 0: a box");
  visit("length", o.length, Unit::meter, between(0.0, 100.0), "of the box, along x");
  visit("width", o.width, Unit::meter, between(0.0, 100.0), "of the box, along y");
}

// The mount, then all that its model has.
template <class Visitor>
void visit_fields(MountedSensor& o, Visitor&& visit) {
  Mount& mount = o.robot_from_sensor;
  visit("sensor", o.file, "the name or the path of its file");
  visit("x", mount.planar.x, Unit::meter, between(-100.0, 100.0), "ahead of the robot's origin");
  visit("y", mount.planar.y, Unit::meter, between(-100.0, 100.0), "to the left of it");
  visit("heading", mount.planar.theta, Unit::radian, "where it looks, counter-clockwise");
  visit("z", mount.z, Unit::meter, between(0.001, 100.0), "above the floor");
  visit("pitch", mount.pitch, Unit::radian, between(-1.5707963267948966, 1.5707963267948966),
        "positive: it looks down");
  visit("roll", mount.roll, Unit::radian, "about the axis along which it looks");
  std::visit([&](auto& model) { visit_fields(model, visit); }, o.model);
}

template <class Visitor>
void visit_fields(Robot& o, Visitor&& visit) {
  visit("about", o.about, "what it is");
  visit("mass", o.mass, Unit::kilogram, between(0.01, 100'000.0), "with everything on it");
  visit("height", o.height, Unit::meter, between(0.01, 100.0), "above the floor");
  visit("footprint", o.footprint, "outline seen from above");
  visit("drive", o.drive, "how it moves");
  visit("odometry", o.odometry, "what it thinks how it moved");
  for (MountedSensor& sensor : o.sensors) visit(sensor.name, sensor, "a sensor and its mount");
}

// By name (robots/NAME.yaml) or by the path of a robot file; paths in it are relative to its
// folder. Throws InputError with place, reason and remedy.
Robot load_robot(const std::string& name_or_path);

// Other sensors in place of the robot's own, at the same mounts: settings of
// "robot.FRONT.sensor", which are taken out of the list, FRONT being a sensor's name. Throws
// InputError.
void exchange_sensors(Settings& settings, Robot& robot);

// Throws InputError where the values do not go together, with `place` in the message: load_robot
// did so already, settings may have changed some since.
void check_robot(const Robot& robot, const SourceLocation& place);

std::vector<std::string> robot_names();

}  // namespace mapbed
