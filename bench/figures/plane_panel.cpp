#include "bench/figures/plane_panel.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Eigenvalues>

#include "core/image/coverage.h"
#include "core/image/drawing.h"

namespace mapbed {
namespace {

constexpr double kReach = 8.0;         // [m] ahead
constexpr double kBehind = 2.0;        // [m] where no laser looks
constexpr double kAside = 5.0;         // [m]
constexpr double kUsableRange = 40.0;  // [m]
constexpr int kCorners = 96;           // of an ellipse; a broken one is drawn every other few
constexpr int kDash = 3;

int pixels(double meters, double per_meter) {
  return std::max(1, static_cast<int>(std::lround(meters * per_meter)));
}

}  // namespace

PlanePanel::PlanePanel(const Eigen::AlignedBox2d& area, double pixels_per_meter)
    : area_(area),
      pixels_per_meter_(pixels_per_meter),
      image_(pixels(area.sizes().x(), pixels_per_meter), pixels(area.sizes().y(), pixels_per_meter),
             kWhite) {}

void PlanePanel::fill(const Eigen::Vector2d& low, double side, const Rgb& color) {
  const Eigen::Vector2d top_left = pixel_of(low + Eigen::Vector2d(0.0, side));
  const Eigen::Vector2d bottom_right = pixel_of(low + Eigen::Vector2d(side, 0.0));
  const auto whole = [](double value, int most) {
    return std::clamp(static_cast<int>(std::lround(value)), 0, most);
  };
  for (int y = whole(top_left.y(), image_.height()); y < whole(bottom_right.y(), image_.height());
       ++y) {
    for (int x = whole(top_left.x(), image_.width()); x < whole(bottom_right.x(), image_.width());
         ++x) {
      image_.at(x, y) = color;
    }
  }
}

void PlanePanel::draw_area_seen(const LaserScan& scan, const Pose2& panel_from_robot) {
  Coverage coverage(image_.width(), image_.height());
  std::size_t first = 0;
  const std::size_t parts = std::max<std::size_t>(1, scan.parts.size());
  for (std::size_t part = 0; part < parts; ++part) {
    const std::size_t end =
        scan.parts.empty() ? scan.ranges.size() : first + scan.parts[part].beams;
    std::vector<Eigen::Vector2d> corners;
    for (std::size_t beam = first; beam < end; ++beam) {
      if (beam == first) {
        corners.push_back(pixel_of(panel_from_robot * scan.point_on(beam, 0.0)));
      }
      const double range =
          std::clamp(scan.ranges[beam], 0.0, std::min(scan.max_range, kUsableRange));
      corners.push_back(pixel_of(panel_from_robot * scan.point_on(beam, range)));
    }
    coverage.add_polygon(corners);
    coverage.blend_into(image_, kSeenColor);
    first = end;
  }
}

void PlanePanel::draw_hits(const LaserScan& scan, const Pose2& panel_from_robot, const Rgb& color) {
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    if (!scan.is_hit(beam)) continue;
    const Eigen::Vector2d end = panel_from_robot * scan.point_on(beam, scan.ranges[beam]);
    if (area_.contains(end)) fill_disc(image_, pixel_of(end), 1.8, color);
  }
}

void PlanePanel::draw_robot(const Pose2& panel_from_robot) {
  constexpr double kRadius = 0.22;  // [m]
  Coverage coverage(image_.width(), image_.height());
  std::vector<Eigen::Vector2d> outline;
  for (const auto& [x, y] : {std::pair{1.5, 0.0}, {-1.0, 1.0}, {-0.5, 0.0}, {-1.0, -1.0}}) {
    outline.push_back(pixel_of(panel_from_robot * Eigen::Vector2d(x * kRadius, y * kRadius)));
  }
  coverage.add_polygon(outline);
  coverage.blend_into(image_, kRobotColor);
}

void PlanePanel::draw_ring(const Eigen::Vector2d& center, double radius, const Rgb& color,
                           bool is_broken) {
  draw_ellipse(center, radius * radius * Eigen::Matrix2d::Identity(), color, is_broken);
}

void PlanePanel::draw_ellipse(const Eigen::Vector2d& center, const Eigen::Matrix2d& covariance,
                              const Rgb& color, bool is_broken) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(covariance);
  const Eigen::Vector2d sigmas = axes.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  const auto point = [&](int i) -> Eigen::Vector2d {
    const double angle = 2.0 * M_PI * i / kCorners;
    const Eigen::Vector2d on_circle(std::cos(angle), std::sin(angle));
    return pixel_of(center + axes.eigenvectors() * sigmas.cwiseProduct(on_circle));
  };
  std::vector<Eigen::Vector2d> line;
  for (int i = 0; i <= kCorners; ++i) {
    line.push_back(point(i));
    if (!is_broken || i % kDash != kDash - 1) continue;
    if (i / kDash % 2 == 0) draw_polyline(image_, line, {.color = color, .width = 1.8});
    line.clear();
  }
  if (!is_broken) draw_polyline(image_, line, {.color = color, .width = 1.8});
}

void PlanePanel::draw_path(const std::vector<Eigen::Vector2d>& path, const Rgb& color) {
  std::vector<Eigen::Vector2d> line;
  for (const Eigen::Vector2d& point : path) line.push_back(pixel_of(point));
  if (!line.empty()) draw_polyline(image_, line, {.color = color, .width = 2.0});
}

void PlanePanel::draw_number(const Eigen::Vector2d& beside, int number, const Rgb& color) {
  if (!area_.contains(beside)) return;
  draw_text(image_, pixel_of(beside) + Eigen::Vector2d(0.28 * pixels_per_meter_, -6.0),
            std::to_string(number), {.size = 15.0, .color = color, .halo = 2.5});
}

void PlanePanel::draw_border() {
  for (int x = 0; x < image_.width(); ++x) {
    image_.at(x, 0) = image_.at(x, image_.height() - 1) = {120, 120, 120};
  }
  for (int y = 0; y < image_.height(); ++y) {
    image_.at(0, y) = image_.at(image_.width() - 1, y) = {120, 120, 120};
  }
}

Eigen::AlignedBox2d area_about(const LaserScan& scan) {
  bool looks_back = false;
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    const Eigen::Vector2d along = scan.point_on(beam, 1.0) - scan.point_on(beam, 0.0);
    looks_back = looks_back || along.x() < -0.9;
  }
  const double behind = looks_back ? kReach : kBehind;
  return {Eigen::Vector2d(-behind, -kAside), Eigen::Vector2d(kReach, kAside)};
}

}  // namespace mapbed
