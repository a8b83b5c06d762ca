#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/geometry/angle.h"

// How strong the answers of tags are in space, by a link budget.

namespace mapbed {

// An antenna in space. The strength of an answer from `x`, where it lies off the boresight by the
// angle a and d away, is
//   level - falloff log10(d / 1 m) - A(a) [dBm],   A = min(12 (a / beam_width)^2, back).
struct SpatialAntenna {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // [m]
  double azimuth = 0.0;                                // [rad] of the boresight
  double elevation = 0.0;                              // [rad] the same, above the horizon
  double beam_width = radians(70.0);                   // [rad] between its points of -3 dB
  double back = 15.0;                                  // [dB] that it is weaker behind, at most
  double level = -65.0;                                // [dBm] of an answer from 1 m ahead
  double falloff = 20.0;                               // [dB] for ten times the distance
};

Eigen::Vector3d boresight(const SpatialAntenna& antenna);
double angle_off_boresight(const SpatialAntenna& antenna, const Eigen::Vector3d& place);  // [rad]
double beam_loss(const SpatialAntenna& antenna, const Eigen::Vector3d& place);            // A [dB]

// Rays also come by a level plane: the field of a tag's mirror image below it is added, there and
// back, with its phase by the length of its way.
struct Reflector {
  double height = 0.0;        // [m] of the plane
  double factor = 0.0;        // of the field that it reflects; 0: there is none
  double wavelength = 0.346;  // [m]
};

// What is too weak is not read, so that those that are read are stronger than the link budget says:
// of strengths about m with this sigma, those above `least` have the mean
//   m + sigma phi(u) / Phi(u),   u = (m - least) / sigma.
struct ReadThreshold {
  double least = -80.0;  // [dBm]
  double sigma = 0.0;    // [dB]; 0: everything is read
};

struct StrengthModel {
  std::vector<SpatialAntenna> antennas;
  std::vector<double> tags;  // [dB] by which a tag's answers are stronger than the mean tag's
  Reflector reflector;
  ReadThreshold threshold;
};

// Mean strength [dBm] of answers from `place` that are read.
double expected_strength(const StrengthModel& model, int antenna, int tag,
                         const Eigen::Vector3d& place);
// Of the mean tag, without regard to what is read: what loops over many tags at a place share.
double link_budget(const StrengthModel& model, int antenna, const Eigen::Vector3d& place);
double mean_of_read(const ReadThreshold& threshold, double strength);

}  // namespace mapbed
