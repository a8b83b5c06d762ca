#pragma once

#include "core/random.h"
#include "core/sensor/laser_scan.h"
#include "robots/robot.h"
#include "sim/sensors/ideal_scan.h"

namespace mapbed {

// What the laser reads. For each beam, in this order:
//   glass     a pane answers with the echo's hit probability, else the beam goes on
//   mixing    several surfaces under one spot: LaserNoise::mixed_pixels
//   darkness  the reflected power, fraction * reflectivity * cos(incidence), limits the range: a
//   beam
//             is lost with probability 1 - Phi(ln(limit / range) / softness),
//             limit = dark_range * sqrt(power / 0.1)
//   gross     missed, short (uniform before the surface), random (uniform up to max_range)
//   error     bias + N(0, sigma(range)) and the device's own error, then whole multiples of step
// A lost beam and one beyond max_range read max_range, one below min_range reads 0: it failed.
//
// Every beam draws from a stream of its own, keyed by laser, sweep and beam: the same beam draws
// the same numbers whatever the others see, and whatever mechanisms are switched on.
LaserScan with_noise(const IdealScan& ideal, const MountedLaser& laser, const Rng& rng);

// What a device has of its own for all its life: drawn with `rng`, the run's, by the laser's
// number.
struct DeviceError {
  double bias = 0.0;   // [m]
  double scale = 1.0;  // of ranges
};
DeviceError device_error(const LaserNoise& noise, int laser, const Rng& rng);

double range_sigma(const LaserNoise& noise, double range);  // [m]

}  // namespace mapbed
