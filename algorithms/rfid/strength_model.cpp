#include "algorithms/rfid/strength_model.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "core/statistics/distributions.h"

namespace mapbed {
namespace {

constexpr double kNearest = 0.1;  // [m] nearer than this tags are as near as this

double strength(const SpatialAntenna& a, const Eigen::Vector3d& place) {
  const double distance = std::max((place - a.position).norm(), kNearest);
  return a.level - a.falloff * std::log10(distance) - beam_loss(a, place);
}

// [dB] that the reflected ray adds to the direct one, there and back.
double reflected(const Reflector& plane, const SpatialAntenna& a, const Eigen::Vector3d& place) {
  if (plane.factor == 0.0) return 0.0;
  Eigen::Vector3d image = place;
  image.z() = 2.0 * plane.height - place.z();
  const double farther = (image - a.position).norm() - (place - a.position).norm();
  // Half of the decibels are of one way, and fields are roots of powers.
  const double ratio = std::pow(10.0, (strength(a, image) - strength(a, place)) / 40.0);
  const std::complex<double> sum =
      1.0 + plane.factor * ratio * std::polar(1.0, -2.0 * kPi * farther / plane.wavelength);
  return 40.0 * std::log10(std::max(std::abs(sum), 1e-2));
}

}  // namespace

Eigen::Vector3d boresight(const SpatialAntenna& a) {
  return {std::cos(a.azimuth) * std::cos(a.elevation), std::sin(a.azimuth) * std::cos(a.elevation),
          std::sin(a.elevation)};
}

double angle_off_boresight(const SpatialAntenna& a, const Eigen::Vector3d& place) {
  const Eigen::Vector3d ahead = boresight(a), there = place - a.position;
  return std::atan2(ahead.cross(there).norm(), ahead.dot(there));
}

double beam_loss(const SpatialAntenna& a, const Eigen::Vector3d& place) {
  const double turned = angle_off_boresight(a, place) / a.beam_width;
  return std::min(12.0 * turned * turned, a.back);
}

double link_budget(const StrengthModel& model, int antenna, const Eigen::Vector3d& place) {
  const SpatialAntenna& a = model.antennas[static_cast<std::size_t>(antenna)];
  return strength(a, place) + reflected(model.reflector, a, place);
}

double mean_of_read(const ReadThreshold& threshold, double strength) {
  if (threshold.sigma <= 0.0) return strength;
  const double u = std::max((strength - threshold.least) / threshold.sigma, -30.0);
  const double density = std::exp(-0.5 * u * u) / std::sqrt(2.0 * kPi);
  return threshold.least + threshold.sigma * (u + density / normal_below(u));
}

double expected_strength(const StrengthModel& model, int antenna, int tag,
                         const Eigen::Vector3d& place) {
  const double of_tag = model.tags[static_cast<std::size_t>(tag)];
  return mean_of_read(model.threshold, link_budget(model, antenna, place) + of_tag);
}

}  // namespace mapbed
