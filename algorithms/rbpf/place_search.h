#pragma once

#include <optional>

#include "algorithms/field/surface_likelihood.h"

namespace mapbed {

// Where a scan fits clearly better than at the optimum next to `guess`, within what a prior allows:
// the optimum of a search over the poses about the prior's mean. None where the optimum next to the
// guess explains `enough` of the scan, or where the search finds nothing better. Gauss-Newton alone
// only finds an optimum that the guess is a cell or two away from: a turn that odometry missed by 5
// degrees moves a wall 40 m away by 3.5 m.
std::optional<Pose2> likelier_place(const Pose2& guess, const ScanForWeighting& scan,
                                    const SurfaceMap& map, const PosePrior& prior,
                                    const SurfaceLikelihood& likelihood, double enough);

}  // namespace mapbed
