#pragma once

#include <memory>
#include <vector>

#include "algorithms/localization/laser_weights.h"

namespace mapbed {

// The same by what beams go through: each is compared with where the first wall of the map lies on
// it (the beam model of Probabilistic Robotics, section 6.3, by its peak). It ends there with the
// noise of laser and map, or before it, by something that is not on the map; behind it seldom.
// Where particles are proposed, and whether a scan is of this map, is still told by end points.
class BeamModelWeights : public LaserWeights {
 public:
  using LaserWeights::LaserWeights;

  bool take(const Measurement& measurement, std::span<const float> beam_weights) override;
  void add_log_weights(std::span<const Pose2> map_from_robot,
                       std::span<double> log_weights) const override;

 private:
  // In the robot's frame.
  struct Ray {
    Eigen::Vector2d from;  // [m] the laser
    Eigen::Vector2d to;    // [m] where the beam ended
    double weight = 1.0;
  };
  double log_likelihood(const Ray& ray, const Pose2& map_from_robot) const;

  std::vector<Ray> rays_;
};

// By the model that the options name.
std::unique_ptr<ParticleWeights> make_laser_weights(const LaserWeightOptions& options,
                                                    const FreeSpace& space, const Rng& rng);

}  // namespace mapbed
