#pragma once

#include <functional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "algorithms/rfid/strength_fit.h"
#include "core/config/option.h"

namespace mapbed {

// What stands for the strength of answers from places that were not measured.
enum class StrengthPredictor : int {
  antenna,          // the mean of the antenna
  antenna_and_tag,  // and of the tag: what a place does is left out
  nearest_place,    // what was measured at the nearest place
  near_places,      // a mean of what was measured, by distance
  link_budget       // a StrengthModel, fitted
};

struct StrengthMapOptions {
  StrengthPredictor predictor = StrengthPredictor::link_budget;
  double near = 0.7;  // [m] sigma of the weights of near_places
  StrengthFitOptions fit;
};

template <class Visitor>
void visit_fields(StrengthMapOptions& o, Visitor&& visit) {
  visit("predictor", o.predictor,
        {"antenna", "antenna_and_tag", "nearest_place", "near_places", "link_budget"},
        "what stands for the strength of answers from a place that was not measured");
  visit("near", o.near, Unit::meter, between(0.01, 100.0),
        "standard deviation of the weights of near_places");
  visit("fit", o.fit, "the parts of a link budget");
}

// Strengths in space, learned from readings.
struct StrengthMap {
  std::function<double(int antenna, const Eigen::Vector3d& place)> of_place;  // the mean tag [dBm]
  std::vector<double> tags;                                                   // [dB] more than it
  ReadThreshold threshold;
  StrengthModel model;  // of a link budget

  double mean(int antenna, int tag, const Eigen::Vector3d& place) const {
    return mean_of_read(threshold, of_place(antenna, place) + tags[static_cast<std::size_t>(tag)]);
  }
};

StrengthMap strength_map(std::span<const StrengthReading> readings, int antennas, int tags,
                         const StrengthMapOptions& options);

}  // namespace mapbed
