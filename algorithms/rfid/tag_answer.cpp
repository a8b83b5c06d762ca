#include "algorithms/rfid/tag_answer.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace mapbed {
namespace {

constexpr double kLeastMass = 0.1;

int modes_of(const TagBelief& belief, double distance) {
  std::vector<double> left = belief.weights;
  int modes = 0;
  for (;;) {
    const auto heaviest = std::max_element(left.begin(), left.end());
    if (heaviest == left.end() || *heaviest <= 0.0) return modes;
    const Eigen::Vector2d centre =
        belief.positions[static_cast<std::size_t>(heaviest - left.begin())];
    double mass = 0.0;
    for (std::size_t i = 0; i < left.size(); ++i) {
      if ((belief.positions[i] - centre).norm() > distance) continue;
      mass += left[i];
      left[i] = 0.0;
    }
    if (mass >= kLeastMass) ++modes;
  }
}

}  // namespace

TagAnswer answer_of(const TagBelief& belief, double distance) {
  TagAnswer answer;
  if (belief.positions.empty()) return answer;
  const auto heaviest = std::max_element(belief.weights.begin(), belief.weights.end());
  answer.most_likely =
      belief.positions[static_cast<std::size_t>(heaviest - belief.weights.begin())];
  for (std::size_t i = 0; i < belief.positions.size(); ++i) {
    answer.mean += belief.weights[i] * belief.positions[i];
  }
  double squares = 0.0;
  for (std::size_t i = 0; i < belief.positions.size(); ++i) {
    squares += belief.weights[i] * (belief.positions[i] - answer.mean).squaredNorm();
  }
  answer.spread = std::sqrt(squares);
  answer.modes = modes_of(belief, distance);
  return answer;
}

}  // namespace mapbed
