#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bench/results/results.h"

// The tables of a result's folder, as CSV. First line: names of the columns.
//
//   runs.csv     run,seed,level,<path of each axis>,variant,<metric>…,failure
//   summary.csv  level,<path of each axis>,variant,metric,unit,runs,failed,missing,
//                mean,low,high,median,min,max
//   claims.csv   claim,held,measured,thesis                    held: yes, no, not judged
//   cost_claims.csv  the same of claims about time
//   cost.csv     run,seconds,recording_seconds,method_seconds,recorded_seconds,peak_memory_bytes
//
// Values of axes stand as in the scenario ("2 deg"), metrics in SI and radians with as many digits
// as it takes to read the same number back; a missing value is an empty field.

namespace mapbed {

std::string runs_csv(const Results& results);
std::string summary_csv(const Results& results);
std::string claims_csv(const Results& results);
std::string cost_claims_csv(const Results& results);  // empty where there are none
std::string cost_csv(const Results& results);

// The rows of a runs.csv; throws InputError where it is not of this plan or has not all its runs.
std::vector<RunRow> parse_runs(const std::string& name, std::string_view csv, const Results& plan);

// Everything of a folder's result again; what was planned (axes, variants, metrics, plots) from its
// config.yaml. Throws InputError where something is missing or damaged.
Results load_results(const std::string& folder);

}  // namespace mapbed
