#pragma once

#include "bench/experiments/experiment.h"

namespace mapbed {

// A method finds the trajectory in a log that was broken on purpose (`faults.…`, see faults.h): how
// much worse than in the clean log, and did it say so? The same noise and chance hold for both.
//
// The error is that of the measured relations, or of the true ones of a simulated drive; of logs
// that have none, of the pairs of another program's path (pairs.h) or else of the method's own path
// in the clean log.
Experiment log_faults_experiment();

// The fraction of the faults in a log that a remark names: of a right kind, and about a time that
// is at most `within` [s] from when the fault was at work, or about the whole log. NaN where no
// fault found a place.
double told_faults(const std::vector<FaultInLog>& faults, const std::vector<Remark>& remarks,
                   double within);

}  // namespace mapbed
