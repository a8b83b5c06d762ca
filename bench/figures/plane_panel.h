#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/geometry/pose2.h"
#include "core/image/image.h"
#include "core/sensor/laser_scan.h"

namespace mapbed {

inline constexpr Rgb kScanColor{60, 60, 60};
inline constexpr Rgb kSeenColor{255, 238, 214};  // what the beams of a scan pass
inline constexpr Rgb kRobotColor{0, 114, 178};
inline constexpr Rgb kTruthColor{204, 121, 167};  // people in truth, as in films

// A part of the plane as a picture: x to the right, y up.
class PlanePanel {
 public:
  PlanePanel(const Eigen::AlignedBox2d& area, double pixels_per_meter);

  const RgbImage& image() const { return image_; }
  RgbImage& image() { return image_; }
  double pixels_per_meter() const { return pixels_per_meter_; }
  Eigen::Vector2d pixel_of(const Eigen::Vector2d& point) const {
    return {(point.x() - area_.min().x()) * pixels_per_meter_,
            (area_.max().y() - point.y()) * pixels_per_meter_};
  }

  // color(point) of each square of that side [m], by its middle.
  template <class Color>
  void shade(double side, Color&& color) {
    for (double y = area_.min().y() + 0.5 * side; y < area_.max().y(); y += side) {
      for (double x = area_.min().x() + 0.5 * side; x < area_.max().x(); x += side) {
        fill({x - 0.5 * side, y - 0.5 * side}, side, color(Eigen::Vector2d(x, y)));
      }
    }
  }

  void draw_area_seen(const LaserScan& scan, const Pose2& panel_from_robot);
  void draw_hits(const LaserScan& scan, const Pose2& panel_from_robot, const Rgb& color);
  void draw_robot(const Pose2& panel_from_robot);
  void draw_ring(const Eigen::Vector2d& center, double radius, const Rgb& color, bool is_broken);
  // One sigma of a normal distribution.
  void draw_ellipse(const Eigen::Vector2d& center, const Eigen::Matrix2d& covariance,
                    const Rgb& color, bool is_broken);
  void draw_path(const std::vector<Eigen::Vector2d>& path, const Rgb& color);
  void draw_number(const Eigen::Vector2d& beside, int number, const Rgb& color);
  void draw_border();

 private:
  void fill(const Eigen::Vector2d& low, double side, const Rgb& color);

  Eigen::AlignedBox2d area_;  // [m]
  double pixels_per_meter_;
  RgbImage image_;
};

// Before the robot, and behind it as far where a laser looks there; in the robot's frame.
Eigen::AlignedBox2d area_about(const LaserScan& scan);

}  // namespace mapbed
