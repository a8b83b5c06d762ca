#pragma once

#include <variant>
#include <vector>

#include <Eigen/Core>

#include "core/config/option.h"
#include "core/geometry/angle.h"

// p(z | x, r) of (7.1) for one antenna: the probability that a tag answers in an inventory round,
// by its place in the antenna's own frame (x ahead, seen from above), learned from a calibration
// run (calibration.h).

namespace mapbed {

// Figure 7.4: an arc in the direction of the antenna, a disc around it, and everywhere else; the
// disc counts where both are.
struct PiecewiseAntenna {
  double direction = 0.0;          // [rad] of the arc's middle
  double opening = radians(95.0);  // [rad] of the arc
  double range = 6.0;              // [m] of the arc
  double disc_radius = 1.0;        // [m]
  double arc_rate = 0.8;           // probability to answer within it
  double disc_rate = 0.8;
  double elsewhere_rate = 0.01;
  // Fraction of rounds that count as saying nothing, with a likelihood of 1/2 wherever the tag is
  // and whether or not it answers. 1: as section 7.2 has it, 1/2 outside of arc and disc.
  double caution = 0.0;
};

// Figure 7.3: what was counted, cell by cell, and by distance where a cell has little of its own.
struct HistogramAntenna {
  double cell_size = 0.5;          // [m]
  int cells = 0;                   // along each side; the antenna is in the middle
  std::vector<double> rounds;      // row by row from low y
  std::vector<double> detections;  // of these
  double prior_rounds = 4.0;       // as so many rounds more, at the rate of the cell's distance
  double elsewhere_rate = 0.01;    // beyond all cells

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(cells) +
           static_cast<std::size_t>(x);
  }
};

// A link budget with its parameters fitted: power over the tag's threshold
//   level - falloff log10(d / 1 m) - A(bearing) [dB],  A = min(12 (bearing / beam_width)^2, back),
// probit in that power over the softness; and the strength of an answer alike.
struct SmoothAntenna {
  double direction = 0.0;             // [rad] in which the beam is strongest
  double beam_width = radians(70.0);  // [rad] between its points of -3 dB
  double back = 15.0;                 // [dB] that it is weaker behind
  double level = 15.0;                // [dB] over the threshold, 1 m ahead
  double falloff = 20.0;              // [dB] for ten times the distance
  double softness = 3.0;              // [dB] standard deviation of what else there is
  double most = 0.95;                 // probability to answer however strong
  double least = 0.005;               // and however weak: by reflection, or not at all
  double rssi = -45.0;                // [dBm] of an answer from 1 m ahead
  double rssi_falloff = 40.0;         // [dB] for ten times the distance
  double rssi_beam = 2.0;             // times A(bearing): there and back
  double rssi_sigma = 4.0;            // [dB]; 0: strengths were not learned
};

template <class Visitor>
void visit_fields(PiecewiseAntenna& o, Visitor&& visit) {
  visit("direction", o.direction, Unit::radian, "of the arc's middle, from straight ahead");
  visit("opening", o.opening, Unit::radian, between(0.0, 2.0 * kPi), "of the arc");
  visit("range", o.range, Unit::meter, between(0.0, 100.0), "of the arc");
  visit("disc_radius", o.disc_radius, Unit::meter, between(0.0, 100.0), "of the disc around it");
  visit("arc_rate", o.arc_rate, kFraction, "probability to answer within the arc");
  visit("disc_rate", o.disc_rate, kFraction, "probability to answer within the disc");
  visit("elsewhere_rate", o.elsewhere_rate, kFraction, "probability to answer anywhere else");
  visit("caution", o.caution, kFraction, "fraction of rounds that count as saying nothing");
}

template <class Visitor>
void visit_fields(HistogramAntenna& o, Visitor&& visit) {
  visit("cell_size", o.cell_size, Unit::meter, between(0.05, 10.0), "side of a cell");
  visit("cells", o.cells, between(0, 400), "along each side, the antenna in the middle");
  visit("rounds", o.rounds, kNotNegative, "that were counted, row by row from the right");
  visit("detections", o.detections, kNotNegative, "in these");
  visit("prior_rounds", o.prior_rounds, between(1e-3, 1e6),
        "as so many rounds more of each cell, at the rate of its distance");
  visit("elsewhere_rate", o.elsewhere_rate, kFraction, "probability to answer beyond all cells");
}

template <class Visitor>
void visit_fields(SmoothAntenna& o, Visitor&& visit) {
  visit("direction", o.direction, Unit::radian, "in which the beam is strongest");
  visit("beam_width", o.beam_width, Unit::radian, between(0.01, 10.0), "between points of -3 dB");
  visit("back", o.back, between(0.0, 100.0), "that it is weaker behind [dB]");
  visit("level", o.level, between(-100.0, 100.0), "over the threshold, 1 m ahead [dB]");
  visit("falloff", o.falloff, between(1.0, 200.0), "for ten times the distance [dB]");
  visit("softness", o.softness, between(0.01, 100.0),
        "standard deviation of what else there is [dB]");
  visit("most", o.most, kFraction, "probability to answer however strong");
  visit("least", o.least, kFraction, "probability to answer however weak");
  visit("rssi", o.rssi, between(-200.0, 100.0), "of an answer from 1 m ahead [dBm]");
  visit("rssi_falloff", o.rssi_falloff, between(-200.0, 200.0), "for ten times the distance [dB]");
  visit("rssi_beam", o.rssi_beam, between(-10.0, 10.0), "times the beam's loss: there and back");
  visit("rssi_sigma", o.rssi_sigma, between(0.0, 100.0),
        "of an answer's strength [dB]; 0: it was not learned");
}

using AntennaModel = std::variant<PiecewiseAntenna, HistogramAntenna, SmoothAntenna>;

double detection_probability(const AntennaModel& antenna, const Eigen::Vector2d& tag_in_antenna);

// As far [m] as a tag answers in every second round, where it is heard best.
double range_of(const AntennaModel& antenna);

// Beyond it [m] the probability is the same everywhere, to within 1 %.
double reach_of(const AntennaModel& antenna);

// Mean strength [dBm] of an answer from there.
double expected_rssi(const SmoothAntenna& antenna, const Eigen::Vector2d& tag_in_antenna);

// Of the cells' own counts and those at their distance.
std::vector<double> rates_of(const HistogramAntenna& antenna);

}  // namespace mapbed
