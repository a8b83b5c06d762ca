#pragma once

#include <Eigen/Core>

#include "robots/rfid_model.h"

namespace mapbed {

// What an antenna is weaker than ahead, at an angle from where it looks [rad]. [dB]
//   A(theta) = min(12 (theta / theta_3dB)^2, A_m)      (as in 3GPP TR 36.814)
double antenna_loss(const RfidModel& model, double angle);

// Field of a dipole of half a wavelength relative to broadside, at an angle from its axis:
//   cos(pi/2 cos psi) / sin psi
double dipole_amplitude(double cos_to_axis);

// How a specimen differs from the sheet: drawn from RfidModel::device alone, so that it stays so
// whatever else is drawn. Device 0 is as the sheet says.
struct RfidDevice {
  double gain = 0.0;                                     // [dB]
  Eigen::Vector3d boresight = Eigen::Vector3d::UnitX();  // in the antenna's frame
  double phase = 0.0;                                    // [rad] of cables and electronics
};
RfidDevice device_of(const RfidModel& model);

}  // namespace mapbed
