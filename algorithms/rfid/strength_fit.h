#pragma once

#include <span>

#include <Eigen/Core>

#include "algorithms/rfid/strength_model.h"
#include "core/config/option.h"

namespace mapbed {

// What an antenna told of a tag at a place, in the mean of all its reads there: what fades at a
// place fades for all of them, so that they count as one.
struct StrengthReading {
  int antenna = 0;
  int tag = 0;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  // [m]
  double strength = 0.0;                            // [dBm]
};

// Which parts of a StrengthModel are fitted; others stay as nothing, a beam as none at all.
struct StrengthFitOptions {
  bool beam = true;
  bool position = false;   // of antennas, within 1 m; else all are at the origin
  bool reflector = false;  // from the best of a lattice of heights and factors
  bool threshold = false;
  double width = 4.0;  // [dB] residuals beyond it count less, see robust_fit.h
};

template <class Visitor>
void visit_fields(StrengthFitOptions& o, Visitor&& visit) {
  visit("beam", o.beam, "boresight and width of the antennas' beams, else they are round");
  visit("position", o.position, "the antennas' places, within 1 m, else all are at the origin");
  visit("reflector", o.reflector, "a level plane that reflects");
  visit("threshold", o.threshold, "what is too weak is not read");
  visit("width", o.width, between(0.1, 100.0), "beyond it residuals count less [dB]");
}

// By level, falloff and tags alone, or with parts besides. Boresights begin where the strongest
// readings are. Every antenna and every tag needs readings of its own.
StrengthModel fitted_strength(std::span<const StrengthReading> readings, int antennas, int tags,
                              const StrengthFitOptions& options = {});

}  // namespace mapbed
