#pragma once

#include <complex>
#include <span>
#include <vector>

#include "core/geometry/pose3.h"
#include "robots/rfid_model.h"
#include "sim/scene/scene.h"
#include "sim/sensors/rfid/antenna_pattern.h"
#include "sim/sensors/rfid/image_paths.h"

namespace mapbed {

// An antenna at its place, with what is its own.
struct PlacedAntenna {
  const RfidModel* model = nullptr;
  RfidDevice device;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();       // [m]
  Eigen::Vector3d boresight = Eigen::Vector3d::UnitX();  // unit, world frame
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();         // unit, world frame
};
PlacedAntenna placed_antenna(const RfidModel& model, const RfidDevice& device,
                             const Pose3& world_from_antenna);

// [dB] of all solids that a straight line goes into, by their materials' crossing loss; what is
// more than `most` need not be right.
double crossing_loss(const Scene& scene, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                     double most);

// The field that comes to a tag's antenna on one way, free of what may stand in it, relative to
// that of a lossless link of 0 dB and without distance:
//   a = 10^(-A/20) g (e . p) lambda / (4 pi d) e^(-2 pi j d / lambda)
// A the antenna's loss where the wave leaves it, g the dipole's amplitude where it arrives, e the
// circular wave after its mirrors, p the dipole's direction across the wave. |e . p| = 1 where
// there is no mirror: what the dipole does not take is RfidModel::polarization_loss. Without
// polarization a mirror takes the mean of both directions' powers.
std::complex<double> path_amplitude(const PlacedAntenna& antenna, const Pose3& world_from_tag,
                                    const RadioPath& path, std::span<const MirrorFace> faces,
                                    const std::vector<Material>& materials);

// What a tag receives in the field 1 [dBm]: all of the budget that is no matter of ways.
//   EIRP + device's gain + G_t - L_pol - L_mat
double budget(const PlacedAntenna& antenna, double tag_loss);

}  // namespace mapbed
