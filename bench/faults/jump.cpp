#include "bench/faults/jump.h"

#include <cmath>
#include <numbers>

#include "bench/faults/fault_instants.h"
#include "bench/faults/odometry_steps.h"

namespace mapbed {
namespace {

constexpr double kSeconds = 2.0;  // in which the robot moves when its odometry jumps

}  // namespace

BrokenLog with_jump(SensorLog log, const JumpOptions& options, Rng rng) {
  if (options.distance == 0.0 && options.turn == 0.0) return {std::move(log)};
  BrokenLog broken{std::move(log)};
  for (const double at : fault_instants(broken.log, options.at, kSeconds, rng)) {
    const double side = rng.uniform(-std::numbers::pi, std::numbers::pi);
    const Pose2 jump{options.distance * std::cos(side), options.distance * std::sin(side),
                     options.turn};
    broken.log = with_steps(std::move(broken.log), [&](const OdometryStep& step) {
      if (at < step.from || at >= step.to) return step.motion;
      broken.when.push_back({step.from, step.to});
      return step.motion * jump;
    });
  }
  return broken;
}

}  // namespace mapbed
