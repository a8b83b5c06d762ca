#pragma once

#include <vector>

#include "algorithms/rfid/strength_model.h"
#include "bench/experiments/rfid_reads/strength_score.h"
#include "bench/results/result_file.h"

namespace mapbed {

// For a paper: predicted and measured strengths of places held out; strengths over the angle off
// the boresight, and maps of the plane, measured and by the model of all places.
std::vector<ResultFile> strength_figures(const StrengthScore& score, const StrengthModel& model,
                                         const std::vector<StrengthCell>& cells,
                                         const PlacedReads& reads);

}  // namespace mapbed
