#include "core/testing/test_room.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/check.h"

namespace mapbed {
namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Poses one period apart: drive, stop, turn, drive.
std::vector<Pose2> path_through(const std::vector<Eigen::Vector2d>& way_points,
                                const DriveOptions& options) {
  const auto steps = [&](double amount, double rate) {
    return std::max(1, static_cast<int>(std::ceil(amount / (rate * options.scan_period) - 1e-9)));
  };
  const auto heading = [](const Eigen::Vector2d& leg) { return std::atan2(leg.y(), leg.x()); };
  std::vector<Pose2> path;
  const Eigen::Vector2d& start = way_points[0];
  path.push_back({start.x(), start.y(), heading(way_points[1] - start)});
  for (std::size_t i = 1; i < way_points.size(); ++i) {
    const Eigen::Vector2d leg = way_points[i] - way_points[i - 1];
    const Pose2 before = path.back();
    const double turn = angle_difference(before.theta, heading(leg));
    const int turns = std::abs(turn) < 1e-9 ? 0 : steps(std::abs(turn), options.turn_rate);
    for (int k = 1; k <= turns; ++k)
      path.push_back({before.x, before.y, normalized_angle(before.theta + turn * k / turns)});
    const int moves = steps(leg.norm(), options.speed);
    for (int k = 1; k <= moves; ++k) {
      const Eigen::Vector2d at = way_points[i - 1] + leg * k / moves;
      path.push_back({at.x(), at.y(), heading(leg)});
    }
  }
  return path;
}

Pose2 with_odometry_noise(const Pose2& motion, const DriveOptions& options, Rng& rng) {
  const double distance = std::hypot(motion.x, motion.y);
  const double turn = std::abs(motion.theta);
  const double forward = rng.normal(0.0, options.forward_sigma * std::sqrt(distance));
  const double heading = rng.normal(0.0, options.turn_sigma * std::sqrt(turn)) +
                         rng.normal(0.0, options.drift_sigma * std::sqrt(distance));
  return {motion.x + forward, motion.y, normalized_angle(motion.theta + heading)};
}

}  // namespace

void TestRoom::add_box(const Eigen::Vector2d& centre, double width, double depth, double turn) {
  const Pose2 room_from_box{centre.x(), centre.y(), turn};
  const double x = width / 2;
  const double y = depth / 2;
  const Eigen::Vector2d corners[] = {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
  for (int i = 0; i < 4; ++i)
    walls_.push_back({room_from_box * corners[i], room_from_box * corners[(i + 1) % 4]});
}

double TestRoom::distance_to_wall(const Eigen::Vector2d& from, double direction) const {
  // from + t d = a + s (b - a), solved by crossing both sides with b - a and with d.
  const Eigen::Vector2d d(std::cos(direction), std::sin(direction));
  double nearest = std::numeric_limits<double>::infinity();
  for (const Segment& wall : walls_) {
    const Eigen::Vector2d along = wall.b - wall.a;
    const Eigen::Vector2d to_a = wall.a - from;
    const double slope = cross(d, along);
    if (slope == 0.0) continue;  // parallel: seen edge on
    const double t = cross(to_a, along) / slope;
    const double s = cross(to_a, d) / slope;
    if (t >= 0.0 && s >= -1e-12 && s <= 1.0 + 1e-12) nearest = std::min(nearest, t);
  }
  return nearest;
}

TestRoom outline(const std::vector<Eigen::Vector2d>& corners) {
  TestRoom room({});
  for (std::size_t i = 0; i < corners.size(); ++i)
    room.add({corners[i], corners[(i + 1) % corners.size()]});
  return room;
}

TestRoom rectangular_room(double width, double height) {
  TestRoom room({});
  room.add_box({0.0, 0.0}, width, height);
  return room;
}

TestRoom l_shaped_room() {
  return outline({{-1, -1}, {5, -1}, {5, 1}, {1, 1}, {1, 4}, {-1, 4}});
}

TestRoom corridor(double length, double width) {
  const double x = length / 2;
  const double y = width / 2;
  return TestRoom({{{-x, -y}, {x, -y}}, {{-x, y}, {x, y}}});
}

TestRoom ring_corridor(double outer, double width) {
  CHECK(outer > 2.0 * width);
  TestRoom room = rectangular_room(outer, outer);
  room.add_box({0.0, 0.0}, outer - 2.0 * width, outer - 2.0 * width);
  return room;
}

TestRoom example_place() {
  TestRoom place = outline({{0, 0}, {20, 0}, {20, 14}, {0, 14}});
  // The corridor, 1.8 m wide, runs round a block that holds two rooms.
  const double door = 1.0;
  const auto wall_with_door = [&](Eigen::Vector2d a, Eigen::Vector2d b, double at) {
    const Eigen::Vector2d along = (b - a).normalized();
    place.add({a, a + along * (at - door / 2)});
    place.add({a + along * (at + door / 2), b});
  };
  wall_with_door({4, 1.8}, {10, 1.8}, 2.0);     // south side of the block: west room
  wall_with_door({10, 1.8}, {18.2, 1.8}, 5.5);  // and east room
  place.add({{4, 9}, {18.2, 9}});
  place.add({{4, 1.8}, {4, 9}});
  place.add({{18.2, 1.8}, {18.2, 9}});
  place.add({{10, 1.8}, {10, 9}});
  // North of the corridor: two more rooms.
  wall_with_door({0, 10.8}, {9, 10.8}, 6.5);
  wall_with_door({9, 10.8}, {20, 10.8}, 4.0);
  place.add({{9, 10.8}, {9, 14}});
  // West of the corridor: shelves and a slanted screen. Corridor: pillars and a cupboard.
  place.add({{0, 3.2}, {2.0, 4.0}});
  place.add_box({0.3, 6.5}, 0.6, 2.4);
  place.add_box({13.0, 0.15}, 0.3, 0.3);
  place.add_box({16.2, 0.15}, 0.3, 0.3);
  place.add_box({19.8, 6.0}, 0.4, 1.6);
  place.add_box({7.0, 9.2}, 1.0, 0.4);
  // Furniture.
  place.add_box({8.6, 6.9}, 1.6, 0.8, 0.3);
  place.add_box({5.0, 7.2}, 0.8, 1.8);
  place.add_box({13.2, 7.0}, 2.0, 1.0);
  place.add_box({16.8, 6.2}, 0.9, 0.9, 0.7);
  place.add_box({11.0, 4.2}, 0.5, 1.5);
  place.add_box({2.2, 13.2}, 1.6, 0.8);
  place.add_box({16.5, 12.8}, 2.4, 0.9, -0.2);
  return place;
}

std::vector<Eigen::Vector2d> example_tour() {
  return {{3, 0.9},   {6, 0.9},  {6, 4.5},  {6, 0.9},   {15.5, 0.9}, {15.5, 4},  {15.5, 0.9},
          {19, 0.9},  {19, 9.9}, {13, 9.9}, {13, 11.9}, {13, 9.9},   {6.5, 9.9}, {6.5, 12},
          {6.5, 9.9}, {3, 9.7},  {3, 0.9},  {19, 0.9},  {19, 9.9},   {3, 9.7},   {3, 2.5}};
}

LaserScan scan_of(const TestRoom& room, const Pose2& map_from_robot, const TestLaser& laser,
                  double time) {
  LaserScan scan;
  scan.time = time;
  scan.robot_from_laser.planar = laser.robot_from_laser;
  scan.first_bearing = laser.first_bearing;
  scan.bearing_step = laser.bearing_step;
  scan.max_range = laser.max_range;
  const Pose2 map_from_laser = map_from_robot * laser.robot_from_laser;
  for (std::size_t beam = 0; beam < static_cast<std::size_t>(laser.beams); ++beam) {
    const double direction = map_from_laser.theta + scan.bearing(beam);
    const double range = room.distance_to_wall(map_from_laser.position(), direction);
    scan.ranges.push_back(std::min(range, laser.max_range));
  }
  return scan;
}

LaserScan with_range_noise(LaserScan scan, double sigma, Rng& rng) {
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    const double error = rng.normal(0.0, sigma);  // drawn for each beam: hits do not shift others
    if (!scan.is_hit(beam)) continue;
    scan.ranges[beam] = std::clamp(scan.ranges[beam] + error, 0.001, scan.max_range);
  }
  return scan;
}

RecordedLog drive_through(const TestRoom& room, const std::vector<Eigen::Vector2d>& way_points,
                          const DriveOptions& options, const Rng& rng) {
  CHECK(way_points.size() >= 2);
  Rng laser_noise = rng.stream("laser");
  Rng odometry_noise = rng.stream("odometry");
  RecordedLog log;
  log.format = "test room";
  Odometry odometry;
  const std::vector<Pose2> path = path_through(way_points, options);
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double time = options.start_time + static_cast<double>(i) * options.scan_period;
    if (i > 0) {
      const Pose2 motion =
          with_odometry_noise(motion_between(path[i - 1], path[i]), options, odometry_noise);
      odometry.odometry_from_robot = odometry.odometry_from_robot * motion;
      odometry.forward_velocity = motion.x / options.scan_period;
      odometry.turn_velocity = motion.theta / options.scan_period;
    }
    odometry.time = time;
    log.measurements.emplace_back(odometry);
    log.measurements.emplace_back(with_range_noise(scan_of(room, path[i], options.laser, time),
                                                   options.range_sigma, laser_noise));
    log.true_poses.push_back({time, path[i]});
  }
  return log;
}

}  // namespace mapbed
