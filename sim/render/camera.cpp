#include "sim/render/camera.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mapbed {
namespace {

constexpr double kMargin = 1.03;  // of the picture around the box

std::array<Eigen::Vector3d, 8> corners_of(const Eigen::AlignedBox3d& box) {
  std::array<Eigen::Vector3d, 8> corners;
  for (std::size_t i = 0; i < 8; ++i) {
    corners[i] = {(i & 1 ? box.max() : box.min()).x(), (i & 2 ? box.max() : box.min()).y(),
                  (i & 4 ? box.max() : box.min()).z()};
  }
  return corners;
}

// Rows: right, up, backwards (towards the eye).
Eigen::Matrix3d axes(const Eigen::Vector3d& backwards, const Eigen::Vector3d& up) {
  const Eigen::Vector3d right = up.cross(backwards).normalized();
  Eigen::Matrix3d rows;
  rows << right.transpose(), backwards.cross(right).transpose(), backwards.transpose();
  return rows;
}

Eigen::Matrix4d view(const Eigen::Matrix3d& rows, const Eigen::Vector3d& eye) {
  Eigen::Matrix4d result = Eigen::Matrix4d::Identity();
  result.topLeftCorner<3, 3>() = rows;
  result.topRightCorner<3, 1>() = -rows * eye;
  return result;
}

Eigen::Matrix4d parallel(const Eigen::AlignedBox3d& seen) {
  Eigen::Matrix4d result = Eigen::Matrix4d::Identity();
  const Eigen::Vector3d scale = 2.0 * seen.sizes().cwiseInverse();
  result.diagonal().head<3>() = Eigen::Vector3d(scale.x(), scale.y(), -scale.z());
  result.topRightCorner<3, 1>() =
      Eigen::Vector3d(-scale.x() * seen.center().x(), -scale.y() * seen.center().y(),
                      scale.z() * seen.center().z());
  return result;
}

}  // namespace

Camera camera_on(const Eigen::AlignedBox3d& box, double azimuth, double elevation, double aspect) {
  Camera camera;
  const Eigen::Vector3d backwards(std::cos(elevation) * std::cos(azimuth),
                                  std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
  camera.up = std::abs(backwards.z()) > 0.999
                  ? Eigen::Vector3d(-std::cos(azimuth), -std::sin(azimuth), 0.0)
                  : Eigen::Vector3d::UnitZ();
  const Eigen::Matrix3d rows = axes(backwards, camera.up);
  const double slope = std::tan(camera.field_of_view / 2) / kMargin;
  camera.target = box.center();
  // The picture's middle is moved until the box is seen as far from the upper edge as from the
  // lower one, and from left as from right; the eye stands just far enough for all of it.
  double distance = 0.0;
  for (int round = 0; round < 20; ++round) {
    distance = 0.0;
    for (const Eigen::Vector3d& corner : corners_of(box)) {
      const Eigen::Vector3d p = rows * (corner - camera.target);
      distance = std::max(
          {distance, p.z() + std::abs(p.y()) / slope, p.z() + std::abs(p.x()) / (slope * aspect)});
    }
    Eigen::AlignedBox2d seen;
    for (const Eigen::Vector3d& corner : corners_of(box)) {
      const Eigen::Vector3d p = rows * (corner - camera.target);
      seen.extend(Eigen::Vector2d(p.head<2>() * distance / (distance - p.z())));
    }
    const Eigen::Vector2d off = seen.center();
    camera.target += rows.row(0).transpose() * off.x() + rows.row(1).transpose() * off.y();
  }
  camera.eye = camera.target + distance * backwards;
  return camera;
}

Camera plan_of(const Eigen::AlignedBox3d& box, double aspect) {
  Camera camera;
  camera.target = box.center();
  camera.eye = camera.target + Eigen::Vector3d(0.0, 0.0, box.sizes().z() + 10.0);
  camera.up = Eigen::Vector3d::UnitY();
  camera.view_height = kMargin * std::max(box.sizes().y(), box.sizes().x() / aspect);
  return camera;
}

Eigen::Matrix4d projection(const Camera& camera, double aspect, const Eigen::AlignedBox3d& box) {
  const Eigen::Matrix3d rows = axes((camera.eye - camera.target).normalized(), camera.up);
  double nearest = 1e30, farthest = 0.0;
  for (const Eigen::Vector3d& corner : corners_of(box)) {
    const double depth = -(rows * (corner - camera.eye)).z();
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  farthest = std::max(farthest, 0.0) + 1.0;
  nearest -= 1.0;
  if (camera.view_height > 0.0) {
    const double y = camera.view_height / 2;
    const Eigen::AlignedBox3d seen(Eigen::Vector3d(-y * aspect, -y, -farthest),
                                   Eigen::Vector3d(y * aspect, y, -nearest));
    return parallel(seen) * view(rows, camera.eye);
  }
  nearest = std::max(nearest, 0.05);
  const double f = 1.0 / std::tan(camera.field_of_view / 2);
  Eigen::Matrix4d perspective = Eigen::Matrix4d::Zero();
  perspective(0, 0) = f / aspect;
  perspective(1, 1) = f;
  perspective(2, 2) = (farthest + nearest) / (nearest - farthest);
  perspective(2, 3) = 2.0 * farthest * nearest / (nearest - farthest);
  perspective(3, 2) = -1.0;
  return perspective * view(rows, camera.eye);
}

Eigen::Matrix4d light_projection(const Eigen::Vector3d& to_light, const Eigen::AlignedBox3d& box) {
  const Eigen::Matrix3d rows = axes(to_light.normalized(), Eigen::Vector3d::UnitY());
  Eigen::AlignedBox3d seen;
  for (const Eigen::Vector3d& corner : corners_of(box)) seen.extend(Eigen::Vector3d(rows * corner));
  return parallel(seen) * view(rows, Eigen::Vector3d::Zero());
}

}  // namespace mapbed
