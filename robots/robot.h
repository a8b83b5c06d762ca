#pragma once

#include <string>
#include <vector>

#include "core/config/option.h"
#include "core/geometry/pose2.h"
#include "robots/drive_model.h"
#include "robots/laser_model.h"
#include "robots/odometry_model.h"

namespace mapbed {

// The robot's outline seen from above, about the robot's origin.
struct RobotFootprint {
  double radius = 0.0;  // [m] a circle; 0: a box
  double length = 0.0;  // [m] of the box, along x
  double width = 0.0;   // [m] of the box, along y

  double reach() const;         // [m] of the circle around it
  double inner_radius() const;  // [m] of the largest circle in it
};

// A laser on the robot. Lasers keep the order of the robot's file: 0 front, 1 rear, …
struct MountedLaser {
  std::string name;        // "front"
  std::string sensor;      // the sensor file's name, "sick_lms200"
  Pose2 robot_from_laser;  // [m], [rad]
  double height = 0.4;     // [m] of the scan plane above the floor
  LaserModel model;
};

// What drives: a data file in robots/, sensors by name from robots/sensors/.
struct Robot {
  std::string name;
  std::string about;
  double mass = 1.0;    // [kg]
  double height = 1.0;  // [m]
  RobotFootprint footprint;
  DriveModel drive;
  OdometryModel odometry;
  std::vector<MountedLaser> lasers;
};

template <class Visitor>
void visit_fields(RobotFootprint& o, Visitor&& visit) {
  visit("radius", o.radius, Unit::meter, kNotNegative, "of a round robot; 0: a box");
  visit("length", o.length, Unit::meter, kNotNegative, "of the box, along x");
  visit("width", o.width, Unit::meter, kNotNegative, "of the box, along y");
}

template <class Visitor>
void visit_fields(Robot& o, Visitor&& visit) {
  visit("about", o.about, "what it is");
  visit("mass", o.mass, Unit::kilogram, kPositive, "with everything on it");
  visit("height", o.height, Unit::meter, kPositive, "above the floor");
  visit("footprint", o.footprint, "outline seen from above");
  visit("drive", o.drive, "how it moves");
  visit("odometry", o.odometry, "what it thinks how it moved");
  for (MountedLaser& laser : o.lasers) visit(laser.name, laser.model, "a laser range finder");
}

// By name (robots/NAME.yaml) or by the path of a robot file. Throws InputError with place, reason
// and remedy.
Robot load_robot(const std::string& name_or_path);
LaserModel load_laser(const std::string& name_or_path);

std::vector<std::string> robot_names();
std::vector<std::string> sensor_names();

}  // namespace mapbed
