#pragma once

#include <string>

#include "bench/results.h"

// The tables of a result's folder, as CSV. First line: names of the columns.
//
//   runs.csv     run,seed,level,<path of each axis>,variant,<metric>…,failure
//   summary.csv  level,<path of each axis>,variant,metric,unit,runs,failed,missing,
//                mean,low,high,median,min,max
//   claims.csv   claim,held,measured,thesis                                   held: yes or no
//   cost.csv     run,seconds,recording_seconds,recorded_seconds,peak_memory_bytes
//
// Values of axes stand as in the scenario ("2 deg"), metrics in SI and radians with as many digits
// as it takes to read the same number back; a missing value is an empty field.

namespace mapbed {

std::string runs_csv(const Results& results);
std::string summary_csv(const Results& results);
std::string claims_csv(const Results& results);
std::string cost_csv(const Results& results);

}  // namespace mapbed
