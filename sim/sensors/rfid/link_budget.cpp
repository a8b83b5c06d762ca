#include "sim/sensors/rfid/link_budget.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/angle.h"
#include "sim/sensors/rfid/fresnel.h"

namespace mapbed {
namespace {

using Complex = std::complex<double>;
using Field = Eigen::Vector3cd;

constexpr double kEndGap = 0.001;  // [m] left out at both ends of a line
constexpr double kInto = 1e-5;     // [m] past a surface, before the next one is looked for

// `vector` without its part along the unit `axis`, of unit length; some direction across the axis
// where nothing is left.
Eigen::Vector3d across(const Eigen::Vector3d& vector, const Eigen::Vector3d& axis) {
  const Eigen::Vector3d rest = vector - vector.dot(axis) * axis;
  const double length = rest.norm();
  return length > 1e-9 ? Eigen::Vector3d(rest / length) : axis.unitOrthogonal();
}

// A circular wave in a direction: two fields across it, a quarter of a period apart.
Field circular(const Eigen::Vector3d& up, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d u = across(up, direction);
  const Eigen::Vector3d v = direction.cross(u);
  return u.cast<Complex>() + Complex(0.0, 1.0) * v.cast<Complex>();
}

// The wave after a mirror: each of its two parts with its own coefficient.
Field reflected(const Field& field, const Eigen::Vector3d& in, const Eigen::Vector3d& out,
                const Eigen::Vector3d& normal, const Reflection& mirror) {
  const Eigen::Vector3d sideways = in.cross(normal);
  const double sine = sideways.norm();
  const Eigen::Vector3d side =
      sine > 1e-9 ? Eigen::Vector3d(sideways / sine) : normal.unitOrthogonal();
  const Complex along_side = side.cast<Complex>().dot(field);
  const Complex in_plane = in.cross(side).eval().cast<Complex>().dot(field);
  return mirror.te * along_side * side.cast<Complex>() +
         mirror.tm * in_plane * out.cross(side).eval().cast<Complex>();
}

}  // namespace

PlacedAntenna placed_antenna(const RfidModel& model, const RfidDevice& device,
                             const Pose3& world_from_antenna) {
  return {&model, device, world_from_antenna.position,
          world_from_antenna.rotation * device.boresight,
          world_from_antenna.rotation * Eigen::Vector3d::UnitZ()};
}

double crossing_loss(const Scene& scene, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                     double most) {
  const Eigen::Vector3d way = to - from;
  const double length = way.norm();
  if (length <= 2.0 * kEndGap) return 0.0;
  Ray ray{from, way / length, kEndGap, length - kEndGap};
  double loss = 0.0;
  while (loss <= most) {
    const Hit hit = scene.cast(ray);
    if (!hit.is_hit()) break;
    const bool goes_in = hit.normal.dot(ray.direction) < 0.0;
    if (goes_in) loss += scene.materials()[static_cast<std::size_t>(hit.material)].crossing_loss;
    ray.min_range = hit.range + kInto;
    if (ray.min_range >= ray.max_range) break;
  }
  return loss;
}

std::complex<double> path_amplitude(const PlacedAntenna& antenna, const Pose3& world_from_tag,
                                    const RadioPath& path, std::span<const MirrorFace> faces,
                                    const std::vector<Material>& materials) {
  const RfidModel& model = *antenna.model;
  Eigen::Vector3d direction = (path.points[1] - path.points[0]).normalized();
  const double angle = std::acos(std::clamp(direction.dot(antenna.boresight), -1.0, 1.0));
  Complex amplitude = std::pow(10.0, -antenna_loss(model, angle) / 20.0);

  Field field = circular(antenna.up, direction);
  for (int k = 0; k < path.mirrors; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const MirrorFace& face = faces[static_cast<std::size_t>(path.faces[at])];
    const Eigen::Vector3d out = (path.points[at + 2] - path.points[at + 1]).normalized();
    const double cosine = std::min(1.0, -direction.dot(face.normal));
    const Reflection mirror =
        reflection_of(materials[static_cast<std::size_t>(face.material)], cosine);
    if (model.polarization) {
      field = reflected(field, direction, out, face.normal, mirror);
    } else {
      amplitude *= -std::sqrt((mirror.te * mirror.te + mirror.tm * mirror.tm) / 2.0);
    }
    direction = out;
  }

  const Eigen::Vector3d dipole = world_from_tag.rotation * Eigen::Vector3d::UnitY();
  if (model.orientation) amplitude *= dipole_amplitude(dipole.dot(direction));
  if (model.polarization) {
    amplitude *= across(dipole, direction).cast<Complex>().dot(field);
  }
  const double waves = 2.0 * kPi * path.length / model.wavelength();
  return amplitude / (2.0 * waves) * std::polar(1.0, -waves);
}

double budget(const PlacedAntenna& antenna, double tag_loss) {
  const RfidModel& model = *antenna.model;
  return model.eirp + antenna.device.gain + model.tag_gain -
         (model.polarization ? model.polarization_loss : 0.0) - (model.backing ? tag_loss : 0.0);
}

}  // namespace mapbed
