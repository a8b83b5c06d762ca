#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace mapbed {

// From where a picture is seen. [m] world frame
struct Camera {
  Eigen::Vector3d eye = {0.0, -10.0, 10.0};
  Eigen::Vector3d target = Eigen::Vector3d::Zero();
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  double field_of_view = 0.6;  // [rad] from the upper to the lower edge
  double view_height = 0.0;    // [m] of what the picture shows; > 0: parallel rays, as a plan
};

// Sees all of a box from a direction: `azimuth` is where the eye stands, counter-clockwise from +x,
// `elevation` how high (pi / 2: from above). `aspect` is width by height of the picture.
Camera camera_on(const Eigen::AlignedBox3d& box, double azimuth, double elevation, double aspect);
// Straight from above, north up, parallel rays.
Camera plan_of(const Eigen::AlignedBox3d& box, double aspect);

// To OpenGL's cube from -1 to 1. `box` is what has to lie between near and far plane.
Eigen::Matrix4d projection(const Camera& camera, double aspect, const Eigen::AlignedBox3d& box);
// For parallel light from a direction: the box fills the cube.
Eigen::Matrix4d light_projection(const Eigen::Vector3d& to_light, const Eigen::AlignedBox3d& box);

}  // namespace mapbed
