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
  double offset;  // in half widths of the beam, -1 to 1
  double share;   // of the light
};

std::vector<SubRay> sub_rays_of(const LaserModel& model) {
  const bool is_line = model.aperture <= 0.0 && model.divergence <= 0.0;
  const int count = is_line ? 1 : model.sub_rays | 1;  // odd: one runs along the axis
  std::vector<SubRay> result;
  double sum = 0.0;
  for (int i = 0; i < count; ++i) {
    const double offset = (2.0 * i + 1.0) / count - 1.0;
    const double chord = std::sqrt(1.0 - offset * offset);
    result.push_back({offset, chord});
    sum += chord;
  }
  for (SubRay& ray : result) ray.share /= sum;
  return result;
}

Ray ray_of(const MountedLaser& laser, const AimedBeam& beam, double offset) {
  const LaserModel& model = laser.model;
  const Pose2 world_from_laser = beam.world_from_robot * laser.robot_from_laser;
  const double axis =
      world_from_laser.theta + model.first_bearing + beam.index * model.bearing_step;
  const double bearing = axis + offset * model.divergence / 2.0;
  const double beside = offset * model.aperture / 2.0;  // to the left of the axis
  Ray ray;
  ray.origin = {world_from_laser.x - beside * std::sin(axis),
                world_from_laser.y + beside * std::cos(axis), laser.height};
  ray.direction = {std::cos(bearing), std::sin(bearing), 0.0};
  ray.max_range = kBeyond * model.max_range;
  return ray;
}

double cos_incidence(const Hit& hit, const Ray& ray) {
  return std::min(1.0, std::abs(hit.normal.dot(ray.direction)));
}

Echo echo_of(const Hit& hit, const Ray& ray, double share, int sub_ray,
             const std::vector<Material>& materials) {
  Echo echo;
  echo.share = static_cast<float>(share);
  echo.sub_ray = sub_ray;
  echo.range = static_cast<float>(hit.range);  // infinite where nothing was hit
  if (!hit.is_hit()) return echo;
  const Material& material = materials[static_cast<std::size_t>(hit.material)];
  const double cosine = cos_incidence(hit, ray);
  echo.cos_incidence = static_cast<float>(cosine);
  echo.reflectivity = static_cast<float>(material.reflectivity);
  echo.hit_probability = static_cast<float>(hit_probability(material, std::acos(cosine)));
  // A pane that answers does so as a mirror: all of the light comes back.
  if (material.transmittance > 0.0) echo.reflectivity = echo.cos_incidence = 1.0F;
  return echo;
}

bool is_glass(const Hit& hit, const std::vector<Material>& materials) {
  return hit.is_hit() && materials[static_cast<std::size_t>(hit.material)].transmittance > 0.0;
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
  const std::vector<Material>& materials = scene.materials();
  const std::size_t last = sub_rays.size() - 1;
  const std::size_t axis = last / 2;

  // The axes and both borders of all beams at once: neighbours run alike.
  const std::size_t n = beams.size();
  std::vector<Ray> rays(3 * n);
  std::vector<Hit> hits(3 * n);
  for (std::size_t i = 0; i < n; ++i) {
    rays[i] = ray_of(laser, beams[i], 0.0);
    rays[n + i] = ray_of(laser, beams[i], sub_rays.front().offset);
    rays[2 * n + i] = ray_of(laser, beams[i], sub_rays[last].offset);
  }
  const std::size_t sent = last > 0 ? 3 * n : n;
  scene.cast(std::span(rays).first(sent), std::span(hits).first(sent));

  std::vector<BeamEchoes> result(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto add = [&](const Ray& ray, const Hit& hit, double share, int sub_ray) {
      result[i].echoes.push_back(echo_of(hit, ray, share, sub_ray, materials));
      if (!is_glass(hit, materials)) return;
      Ray through = ray;
      through.through_glass = true;
      result[i].echoes.push_back(echo_of(scene.cast(through), ray, share, sub_ray, materials));
    };
    result[i].truth = truth_of(hits[i]);
    const bool one_surface = last == 0 || (is_same_surface(hits[i], hits[n + i]) &&
                                           is_same_surface(hits[i], hits[2 * n + i]));
    if (one_surface) {
      add(rays[i], hits[i], 1.0, 0);
      continue;
    }
    for (std::size_t k = 0; k <= last; ++k) {
      if (k == 0 || k == axis || k == last) {
        const std::size_t at = (k == axis ? 0 : k == 0 ? n : 2 * n) + i;
        add(rays[at], hits[at], sub_rays[k].share, static_cast<int>(k));
        continue;
      }
      const Ray ray = ray_of(laser, beams[i], sub_rays[k].offset);
      add(ray, scene.cast(ray), sub_rays[k].share, static_cast<int>(k));
    }
  }
  return result;
}

}  // namespace mapbed
