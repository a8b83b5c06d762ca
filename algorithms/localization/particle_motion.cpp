#include "algorithms/localization/particle_motion.h"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

constexpr std::size_t kBlock = 1024;  // particles of one stream

MotionModelOptions with_larger_sigmas(MotionModelOptions errors, double factor) {
  for (double* sigma : {&errors.rotation_per_rotation, &errors.rotation_per_meter,
                        &errors.translation_per_meter, &errors.translation_per_rotation,
                        &errors.least_rotation_sigma, &errors.least_translation_sigma}) {
    *sigma *= factor;
  }
  return errors;
}

template <class Move>
void move_blocks(std::vector<Pose2>& poses, const Rng& streams, const Move& move) {
  tbb::parallel_for(std::size_t{0}, (poses.size() + kBlock - 1) / kBlock, [&](std::size_t block) {
    Rng rng = streams.stream("block", block);
    const std::size_t end = std::min(poses.size(), (block + 1) * kBlock);
    for (std::size_t i = block * kBlock; i < end; ++i) poses[i] = move(poses[i], rng);
  });
}

}  // namespace

void move_particles(std::vector<Pose2>& map_from_robot, const Pose2& measured,
                    const ParticleErrors& errors, const Rng& streams) {
  const MotionModelOptions slipped = with_larger_sigmas(errors.usual, errors.slip_factor);
  move_blocks(map_from_robot, streams, [&](const Pose2& pose, Rng& rng) {
    const bool slips = rng.uniform() < errors.slip_share;
    return pose * sampled_motion(measured, slips ? slipped : errors.usual, rng);
  });
}

void move_particles(std::vector<Pose2>& map_from_robot, double seconds,
                    const RandomStepOptions& steps, const Rng& streams) {
  const double root = std::sqrt(std::max(0.0, seconds));
  move_blocks(map_from_robot, streams, [&](const Pose2& pose, Rng& rng) -> Pose2 {
    const double x = rng.normal(pose.x, steps.position * root);
    const double y = rng.normal(pose.y, steps.position * root);
    return {x, y, normalized_angle(rng.normal(pose.theta, steps.heading * root))};
  });
}

}  // namespace mapbed
