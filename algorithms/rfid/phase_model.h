#pragma once

#include <complex>
#include <span>
#include <vector>

#include <Eigen/Core>

// Phases of tags' answers, as their ways there and back give them.

namespace mapbed {

// Of all reads of a tag at a place by an antenna on a carrier: the mean of exp(j m phi). m = 2
// where a reader tells phases but for half a turn.
struct PhaseReading {
  int channel = 0;  // antenna, carrier and tag: these share an offset that nobody knows
  // [m] of the tag from the antenna, as far as it is known
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  double wavelength = 0.0;
  double reads = 0.0;
  std::complex<double> mean;
};

// m 4 pi d / lambda, with the tag (or, against it, the antenna) `shift` farther.
double expected_phase(const PhaseReading& reading, const Eigen::Vector3d& shift, int turns);

// What is left of the readings' means, once turned back by what is expected.
std::vector<std::complex<double>> turned_back(std::span<const PhaseReading> readings,
                                              std::span<const Eigen::Vector3d> shifts, int turns);

// The shift within a cube of this half side [m] with which the channels' readings agree best,
//   sum over channels c of | sum over readings i of c  mean_i exp(-j expected_i) |,
// on a lattice of a 14th of the wavelength over `turns`, then about its best point. `reference`
// are the shifts that there are besides.
Eigen::Vector3d best_shift(std::span<const PhaseReading> readings,
                           std::span<const Eigen::Vector3d> reference, double half_side, int turns);

// The von Mises distribution exp(kappa cos x) / (2 pi I0(kappa)).
double log_von_mises(double cosine, double kappa);
double kappa_of(double mean_cosine);  // of greatest likelihood; 0 where that is not positive

}  // namespace mapbed
