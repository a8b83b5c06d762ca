#pragma once

#include <span>
#include <vector>

#include "robots/robot.h"
#include "sim/scene/scene.h"
#include "sim/sensors/ideal_scan.h"
#include "sim/truth/beam_truth.h"

namespace mapbed {

// One beam to send: which one, and where the robot is at its moment.
struct AimedBeam {
  int index = 0;
  Pose2 world_from_robot;
};

struct BeamEchoes {
  BeamTruth truth;
  std::vector<Echo> echoes;
};

// Sends the beams into the scene as it stands; the result has one element a beam. Beams lie in the
// laser's own plane, which its mount may tilt. The spot of a
// beam is as wide as its aperture and divergence make it, and evenly lit: sub-rays across it, with
// fractions as the chords of a disc. Where the axis and both outer sub-rays meet one opaque
// surface, the axis stands for all. Behind a pane follows the first opaque surface on the same
// line.
std::vector<BeamEchoes> cast_beams(const Scene& scene, const MountedLaser& laser,
                                   std::span<const AimedBeam> beams);

}  // namespace mapbed
