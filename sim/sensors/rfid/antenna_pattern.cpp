#include "sim/sensors/rfid/antenna_pattern.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/angle.h"
#include "core/geometry/pose3.h"
#include "core/random.h"

namespace mapbed {

double antenna_loss(const RfidModel& model, double angle) {
  const double relative = angle / model.beam_width;
  return std::min(12.0 * relative * relative, model.front_to_back);
}

double dipole_amplitude(double cos_to_axis) {
  const double sine_squared = 1.0 - cos_to_axis * cos_to_axis;
  if (sine_squared < 1e-12) return 0.0;
  return std::cos(kPi / 2.0 * cos_to_axis) / std::sqrt(sine_squared);
}

RfidDevice device_of(const RfidModel& model) {
  if (model.device == 0) return {};
  Rng rng = Rng(static_cast<std::uint64_t>(model.device)).stream("rfid device");
  RfidDevice device;
  device.gain = rng.normal(0.0, model.gain_spread);
  const double yaw = rng.normal(0.0, model.pointing_spread);
  const double pitch = rng.normal(0.0, model.pointing_spread);
  device.boresight = rotation_of(yaw, pitch, 0.0) * Eigen::Vector3d::UnitX();
  device.phase = rng.uniform(0.0, 2.0 * kPi);
  return device;
}

}  // namespace mapbed
