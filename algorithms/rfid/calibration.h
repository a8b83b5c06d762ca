#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "algorithms/rfid/antenna_model.h"

// Learning an antenna's model from a calibration run: the robot turns in front of a tag whose place
// is known, at several distances (section 7.2).

namespace mapbed {

// One inventory round of one antenna, as it was for one tag.
struct CalibrationReading {
  Eigen::Vector2d tag_in_antenna;
  bool detected = false;
  std::optional<double> rssi = {};  // [dBm] of the answer, where it tells
};

struct HistogramOptions {
  double cell_size = 0.5;  // [m]
  double reach = 9.0;      // [m] of the table, from the antenna to its sides
};
HistogramAntenna counted_histogram(std::span<const CalibrationReading> readings,
                                   const HistogramOptions& options = {});

// Arc, disc and rates of greatest likelihood, on a lattice of 2.5 degrees and 0.1 m.
PiecewiseAntenna fitted_piecewise(std::span<const CalibrationReading> readings);

// All parameters of greatest likelihood but the falloff, which is free space's: the scale of
// decibels would be free else. The strength of answers by least squares.
SmoothAntenna fitted_smooth(std::span<const CalibrationReading> readings);

// Mean of ln p(z | x, r) over readings that need not be those it was learned from.
double mean_log_likelihood(const AntennaModel& antenna,
                           std::span<const CalibrationReading> readings);
// The same of the strengths of answers, as a density per dB; NaN where there are none.
double mean_log_likelihood_of_rssi(const SmoothAntenna& antenna,
                                   std::span<const CalibrationReading> readings);

}  // namespace mapbed
