#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace mapbed {

// A tag's place from the phases of its answers along the robot's path, as a synthetic aperture
// (Miesen, Kirsch and Vossiek 2011): where the phases that the place would give agree with those
// that were measured,
//
//   S(x) = sum over antennas a of | sum over reads i of a  exp(j (phi_i - 4 pi |x - r_i| / lambda))
//   |
//
// over the number of reads; each antenna and carrier has an offset of its own, which is why only
// reads of one are summed as they are. 1: all agree. Errors of the path of more than an eighth of a
// wavelength (4 cm) within the aperture blur it.
struct PhaseRead {
  Eigen::Vector3d antenna;  // [m] its place in the map
  double phase = 0.0;       // [rad]
  double wavelength = 0.0;  // [m]
  int channel = 0;          // antenna and carrier: reads of one channel share the offset
};

struct ApertureOptions {
  double spacing = 0.03;  // [m] between reads that are used; nearer ones tell the same
  double step = 0.04;     // [m] of the search, then down to a tenth of it about the best place
};

struct ApertureAnswer {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // [m]
  double agreement = 0.0;                              // S at it, in [0, 1]
  int reads = 0;                                       // that were used
};

// The best place within `box` [m], which may be flat.
ApertureAnswer focused(std::span<const PhaseRead> reads, const Eigen::AlignedBox3d& box,
                       const ApertureOptions& options = {});

// S at one place.
double phase_agreement(std::span<const PhaseRead> reads, const Eigen::Vector3d& place);

}  // namespace mapbed
