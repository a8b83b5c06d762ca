#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/geometry/angle.h"
#include "core/log/log_file.h"
#include "core/random.h"

// Tiny worlds of straight walls for tests, and logs of drives through them. Rays are exact.

namespace mapbed {

struct Segment {
  Eigen::Vector2d a;  // [m]
  Eigen::Vector2d b;  // [m]
};

class TestRoom {
 public:
  explicit TestRoom(std::vector<Segment> walls) : walls_(std::move(walls)) {}

  const std::vector<Segment>& walls() const { return walls_; }
  void add(const Segment& wall) { walls_.push_back(wall); }
  void add_box(const Eigen::Vector2d& centre, double width, double depth, double turn = 0.0);

  // [m] to the nearest wall in a direction (x axis: 0, counter-clockwise); infinity where none is.
  double distance_to_wall(const Eigen::Vector2d& from, double direction) const;

 private:
  std::vector<Segment> walls_;
};

// A closed outline through the corners.
TestRoom outline(const std::vector<Eigen::Vector2d>& corners);

TestRoom rectangular_room(double width, double height);  // the origin is its centre
TestRoom l_shaped_room();                                // 6 m x 5 m, origin inside the bend
TestRoom corridor(double length, double width = 2.0);    // open at both ends, along x
TestRoom ring_corridor(double outer = 12.0, double width = 2.0);  // a square loop about the origin

// Four furnished rooms about a corridor that leads round in a loop: 20 m x 14 m, origin at the
// south west corner. `example_tour` drives round it twice and looks into the rooms.
TestRoom example_place();
std::vector<Eigen::Vector2d> example_tour();

struct TestLaser {
  int beams = 181;
  double first_bearing = -kPi / 2;     // [rad]
  double bearing_step = radians(1.0);  // [rad]
  double max_range = 8.0;              // [m] also the reading where nothing was hit
  Pose2 robot_from_laser;
};

// What the laser would see without noise.
LaserScan scan_of(const TestRoom& room, const Pose2& map_from_robot, const TestLaser& laser = {},
                  double time = 0.0);

// Adds normal noise to the readings that are hits.
LaserScan with_range_noise(LaserScan scan, double sigma, Rng& rng);

// Straight from way-point to way-point, turning on the spot between them.
struct DriveOptions {
  TestLaser laser;
  double speed = 0.5;          // [m/s]
  double turn_rate = 0.8;      // [rad/s]
  double scan_period = 0.25;   // [s]
  double start_time = 1000.0;  // [s]
  double range_sigma = 0.01;   // [m]
  // Odometry: the sigma of a motion's error is that of a metre or a radian times the root of the
  // motion's length, so that it does not depend on how finely the path is cut.
  double forward_sigma = 0.03;  // [m] of the way, after 1 m
  double turn_sigma = 0.05;     // [rad] of the turn, after 1 rad
  double drift_sigma = 0.02;    // [rad] of the heading, after 1 m
};

// Odometry (starting at the origin of its own frame), scans and true poses at the same stamps.
RecordedLog drive_through(const TestRoom& room, const std::vector<Eigen::Vector2d>& way_points,
                          const DriveOptions& options, const Rng& rng);

}  // namespace mapbed
