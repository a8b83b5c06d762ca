#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "algorithms/rfid/strength_fit.h"
#include "bench/experiments/rfid_reads/strength_map.h"

namespace mapbed {

// Where tags are, by how strong they answer: anywhere in a box beforehand, each strength normal
// about its mean, no surer of anything beyond two sigma.
class PlaceSearch {
 public:
  PlaceSearch(const StrengthMap& map, double sigma, const Eigen::AlignedBox3d& box, double step,
              int antennas);

  // The mean of what is believed of the place that all of these are from; their own is not used.
  Eigen::Vector3d place_of(std::span<const StrengthReading> readings) const;

 private:
  std::size_t tags_ = 0;
  double sigma_ = 1.0;  // [dB]
  std::vector<Eigen::Vector3d> lattice_;
  std::vector<std::vector<double>> means_;  // by antenna and tag, at each point of the lattice
};

// Of places that were measured, the one whose readings are most alike: by the mean square
// difference [dB^2], where one of both lacks a reading by `missing` squared.
Eigen::Vector3d most_alike(std::span<const StrengthReading> readings,
                           std::span<const StrengthReading> measured, double missing = 6.0);

}  // namespace mapbed
