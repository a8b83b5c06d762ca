#include "sim/sensors/ideal_laser.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/pose3.h"

namespace mapbed {
namespace {

constexpr double kBeyond = 1.05;  // times max_range: what cannot be read need not be hit

// Where a sub-ray runs beside the axis.
struct SubRay {
  double fraction = 0.0;  // of the light
  double beside = 0.0;    // [m] to the left of the axis
  double c = 1.0;         // cosine and sine of the angle to the axis
  double s = 0.0;
};

std::vector<SubRay> sub_rays_of(const LaserModel& model) {
  const bool is_line = model.aperture <= 0.0 && model.divergence <= 0.0;
  const int count = is_line ? 1 : model.sub_rays | 1;  // odd: one runs along the axis
  std::vector<SubRay> result;
  double sum = 0.0;
  for (int i = 0; i < count; ++i) {
    const double offset = (2.0 * i + 1.0) / count - 1.0;  // in half widths of the beam, -1 to 1
    const double angle = offset * model.divergence / 2.0;
    const double chord = std::sqrt(1.0 - offset * offset);
    result.push_back({chord, offset * model.aperture / 2.0, std::cos(angle), std::sin(angle)});
    sum += chord;
  }
  for (SubRay& ray : result) ray.fraction /= sum;
  return result;
}

// A beam in the world frame.
struct Axis {
  Eigen::Vector3d origin;  // [m]
  Eigen::Vector3d along;   // unit
  Eigen::Vector3d left;    // unit, square to it in the laser's plane
};

Axis axis_of(const MountedLaser& laser, const AimedBeam& beam) {
  const Mount& mount = laser.robot_from_laser;
  const Pose2 world_from_laser = beam.world_from_robot * mount.planar;
  const Eigen::Vector3d origin(world_from_laser.x, world_from_laser.y, mount.z);
  const bool is_tilted = mount.pitch != 0.0 || mount.roll != 0.0;
  const double heading = is_tilted ? 0.0 : world_from_laser.theta;
  const double bearing =
      heading + laser.model.first_bearing + beam.index * laser.model.bearing_step;
  const double c = std::cos(bearing);
  const double s = std::sin(bearing);
  if (!is_tilted) return {origin, {c, s, 0.0}, {-s, c, 0.0}};
  const Eigen::Quaterniond turn = rotation_of(world_from_laser.theta, mount.pitch, mount.roll);
  return {origin, turn * Eigen::Vector3d(c, s, 0.0), turn * Eigen::Vector3d(-s, c, 0.0)};
}

Ray ray_of(const MountedLaser& laser, const Axis& axis, const SubRay& sub_ray) {
  Ray ray;
  ray.origin = axis.origin + sub_ray.beside * axis.left;
  ray.direction = sub_ray.c * axis.along + sub_ray.s * axis.left;
  ray.max_range = kBeyond * laser.model.max_range;
  return ray;
}

double cos_incidence(const Hit& hit, const Ray& ray) {
  return std::min(1.0, std::abs(hit.normal.dot(ray.direction)));
}

Echo echo_of(const Hit& hit, const Ray& ray, double fraction, int sub_ray,
             const std::vector<Material>& materials) {
  Echo echo;
  echo.fraction = static_cast<float>(fraction);
  echo.sub_ray = sub_ray;
  echo.range = static_cast<float>(hit.range);  // infinite where nothing was hit
  if (!hit.is_hit()) return echo;
  const Material& material = materials[static_cast<std::size_t>(hit.material)];
  const double cosine = cos_incidence(hit, ray);
  echo.cos_incidence = static_cast<float>(cosine);
  echo.reflectivity = static_cast<float>(material.reflectivity);
  if (material.transmittance <= 0.0) return echo;
  // A pane that answers does so as a mirror: all of the light comes back.
  echo.hit_probability = static_cast<float>(hit_probability(material, std::acos(cosine)));
  echo.reflectivity = echo.cos_incidence = 1.0F;
  return echo;
}

bool is_glass(const Hit& hit, const std::vector<Material>& materials) {
  return hit.is_hit() && materials[static_cast<std::size_t>(hit.material)].transmittance > 0.0;
}

// Of one sub-ray; behind glass follows what stands there.
void add_echoes(const Scene& scene, const Ray& ray, const Hit& hit, double fraction, int sub_ray,
                std::vector<Echo>& echoes) {
  echoes.push_back(echo_of(hit, ray, fraction, sub_ray, scene.materials()));
  if (!is_glass(hit, scene.materials())) return;
  Ray through = ray;
  through.through_glass = true;
  echoes.push_back(echo_of(scene.cast(through), ray, fraction, sub_ray, scene.materials()));
}

bool is_same_surface(const Hit& a, const Hit& b) {
  return a.entity == b.entity && a.part == b.part && (!a.is_hit() || a.normal.dot(b.normal) > 0.9);
}

BeamTruth truth_of(const Hit& hit) {
  BeamTruth truth;
  truth.range = static_cast<float>(hit.range);
  truth.entity = hit.entity;
  truth.part = hit.part;
  truth.material = hit.material;
  return truth;
}

}  // namespace

std::vector<BeamEchoes> cast_beams(const Scene& scene, const MountedLaser& laser,
                                   std::span<const AimedBeam> beams) {
  const std::vector<SubRay> sub_rays = sub_rays_of(laser.model);
  const std::size_t width = sub_rays.size();
  const std::size_t axis = width / 2;
  const std::size_t n = beams.size();
  std::vector<Axis> axes;
  for (const AimedBeam& beam : beams) axes.push_back(axis_of(laser, beam));

  // All beams at once: neighbours run alike. First the axes and both borders ...
  std::vector<Ray> rays;
  for (const std::size_t k : {axis, std::size_t{0}, width - 1}) {
    for (std::size_t i = 0; i < n && (k == axis || width > 1); ++i) {
      rays.push_back(ray_of(laser, axes[i], sub_rays[k]));
    }
  }
  std::vector<Hit> hits(rays.size());
  scene.cast(rays, hits);

  // ... then all sub-rays of the beams whose spot is not on one surface.
  std::vector<Ray> edge_rays;
  std::vector<bool> on_edge(n, false);
  for (std::size_t i = 0; i < n && width > 1; ++i) {
    on_edge[i] =
        !is_same_surface(hits[i], hits[n + i]) || !is_same_surface(hits[i], hits[2 * n + i]);
    if (!on_edge[i]) continue;
    for (const SubRay& sub_ray : sub_rays) edge_rays.push_back(ray_of(laser, axes[i], sub_ray));
  }
  std::vector<Hit> edge_hits(edge_rays.size());
  scene.cast(edge_rays, edge_hits);

  std::vector<BeamEchoes> result(n);
  for (std::size_t i = 0, next = 0; i < n; ++i) {
    result[i].truth = truth_of(hits[i]);
    if (!on_edge[i]) {
      add_echoes(scene, rays[i], hits[i], 1.0, 0, result[i].echoes);
      continue;
    }
    for (std::size_t k = 0; k < width; ++k, ++next) {
      add_echoes(scene, edge_rays[next], edge_hits[next], sub_rays[k].fraction, static_cast<int>(k),
                 result[i].echoes);
    }
  }
  return result;
}

}  // namespace mapbed
