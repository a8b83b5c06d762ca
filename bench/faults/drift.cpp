#include "bench/faults/drift.h"

#include <cmath>

#include "bench/faults/fault_instants.h"
#include "bench/faults/odometry_steps.h"
#include "core/geometry/angle.h"

namespace mapbed {

BrokenLog with_drift(SensorLog log, const DriftOptions& options, Rng /*rng*/) {
  if (options.turn_per_meter == 0.0 || log.empty()) return {std::move(log)};
  const TimeInterval whole = whole_of(log);
  return {with_steps(std::move(log),
                     [&options](const OdometryStep& step) {
                       const double way = std::hypot(step.motion.x, step.motion.y);
                       const double turn = step.motion.theta + options.turn_per_meter * way;
                       return Pose2{step.motion.x, step.motion.y, normalized_angle(turn)};
                     }),
          {whole}};
}

}  // namespace mapbed
