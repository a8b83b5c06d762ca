#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/geometry/pose2.h"
#include "core/random.h"
#include "core/sensor/measurement.h"

namespace mapbed {

// What one kind of sensor says of the particles of Monte Carlo localisation, (7.3): ln p(z | x) for
// each of them. Those of several sensors add up.
class ParticleWeights {
 public:
  virtual ~ParticleWeights() = default;

  // Whether the measurement is of this kind and says something; the functions below are then about
  // it until the next one is taken. Beam weights as Estimator::add() has them.
  virtual bool take(const Measurement& measurement, std::span<const float> beam_weights) = 0;

  // While the robot stands, the next measurement repeats what the one before said (scans of the
  // same walls): such ones are taken after a motion, or seldom. False: each of them is news.
  virtual bool repeats_at_rest() const { return true; }

  // Adds ln p(z | x), up to a constant that all share, for each map_from_robot: tempered where what
  // it consists of is dependent. For any division of the poses the same values.
  virtual void add_log_weights(std::span<const Pose2> map_from_robot,
                               std::span<double> log_weights) const = 0;

  // The likelihood of one of the readings that it consists of, on average, seen from a pose:
  // compared over time it shows that measurements get unlikely.
  virtual double likelihood_of_reading(const Pose2& map_from_robot) const;

  // A pose drawn from where the measurement may have been made, whatever was believed before: by
  // that, particles begin and come back. None: it may be anywhere.
  virtual std::optional<Pose2> propose(Rng& rng) const = 0;

  // ln p(z | x) / p(z | a place that is not on this map), tempered in the same way. None: a sensor
  // that cannot tell.
  virtual std::optional<double> log_odds_of_map(const Pose2& map_from_robot) const = 0;
};

// One of the poses, drawn by ln p(z | x) of each, or by how likely the measurement is from there.
// Not for an empty list.
Pose2 drawn_by(const std::vector<double>& log_weights, std::span<const Pose2> map_from_robot,
               Rng& rng);
Pose2 drawn_by(const ParticleWeights& weights, std::span<const Pose2> map_from_robot, Rng& rng);

}  // namespace mapbed
