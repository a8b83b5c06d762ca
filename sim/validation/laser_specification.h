#pragma once

#include <vector>

#include "robots/laser_model.h"
#include "sim/validation/laser_target.h"

namespace mapbed {

// What readings of a target should be distributed like: element k is the probability of a reading
// of k steps; the last one is that of nothing being seen.
using ReadingFractions = std::vector<double>;

struct SpotModel {
  int sub_rays = 5;        // across the spot, with fractions as the chords of an evenly lit disc
  bool axis_alone = true;  // where axis and both borders meet one surface, the axis stands for all
};
// As the simulated laser takes its spot.
SpotModel spot_model_of(const LaserModel& laser);

// In closed form from the description of the laser (sim/noise/laser_noise.h, LaserNoise) and plane
// geometry; nothing is drawn. The laser's place is uniform over the target's width; the integral
// over it is by the midpoint rule with `places` places. Readings must come in steps.
ReadingFractions specified_fractions(const LaserTarget& target, const LaserModel& laser,
                                     const SpotModel& spot, int places = 5000);

// Index of a reading in ReadingFractions.
std::size_t reading_index(double reading, const LaserModel& laser);

}  // namespace mapbed
