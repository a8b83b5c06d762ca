#pragma once

#include "algorithms/tag_belief.h"

namespace mapbed {

// What is said of a tag, where one place is asked for.
struct TagAnswer {
  Eigen::Vector2d most_likely = Eigen::Vector2d::Zero();  // [m]
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();         // [m]
  double spread = 0.0;  // [m] root of the mean squared distance from the mean
  int modes = 0;        // places that each hold a tenth of what is believed
};

// A mode is what lies within `distance` [m] of its heaviest position.
TagAnswer answer_of(const TagBelief& belief, double distance = 1.0);

}  // namespace mapbed
