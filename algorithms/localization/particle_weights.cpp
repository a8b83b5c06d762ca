#include "algorithms/localization/particle_weights.h"

#include <cmath>

#include "algorithms/particles/resampling.h"

namespace mapbed {

double ParticleWeights::likelihood_of_reading(const Pose2& map_from_robot) const {
  double log = 0.0;
  add_log_weights({&map_from_robot, 1}, {&log, 1});
  return std::exp(log);
}

Pose2 drawn_by(const std::vector<double>& log_weights, std::span<const Pose2> map_from_robot,
               Rng& rng) {
  const std::vector<double> fractions = normalized(log_weights);
  double rest = rng.uniform();
  std::size_t chosen = 0;
  while (chosen + 1 < fractions.size() && rest >= fractions[chosen]) rest -= fractions[chosen++];
  return map_from_robot[chosen];
}

Pose2 drawn_by(const ParticleWeights& weights, std::span<const Pose2> map_from_robot, Rng& rng) {
  std::vector<double> logs(map_from_robot.size(), 0.0);
  weights.add_log_weights(map_from_robot, logs);
  return drawn_by(logs, map_from_robot, rng);
}

}  // namespace mapbed
