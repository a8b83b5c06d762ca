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
//   series.csv   run,series,x,value
//   claims.csv   claim,held,measured,thesis                    held: yes, no, not judged
//   cost_claims.csv  the same of claims about time
//   cost.csv     run,seconds,recording_seconds,method_seconds,recorded_seconds,peak_memory_bytes
//   files.csv    run,seed,level,<path of each axis>,variant,path,title    pictures of single runs
//
// Values of axes stand as in the scenario ("2 deg"), metrics in SI and radians with as many digits
// as it takes to read the same number back; a missing value is an empty field. Tables that have
// nothing to tell in most scenarios are empty texts then: series, cost_claims and files.

namespace mapbed {

std::string runs_csv(const Results& results);
std::string summary_csv(const Results& results);
std::string series_csv(const Results& results);
std::string claims_csv(const Results& results);
std::string cost_claims_csv(const Results& results);
std::string cost_csv(const Results& results);
std::string files_csv(const Results& results);

// The rows of such a text again; `name` is the file's. All throw InputError where it is damaged or
// not of this plan.
std::vector<RunRow> parse_runs(const std::string& name, std::string_view csv, const Results& plan);
std::vector<SummaryRow> parse_summary(const std::string& name, std::string_view csv,
                                      const Results& plan);
std::vector<Series> parse_series(const std::string& name, std::string_view csv,
                                 const Results& plan);
std::vector<Verdict> parse_verdicts(const std::string& name, std::string_view csv, bool of_cost);
std::vector<CostRow> parse_costs(const std::string& name, std::string_view csv);
std::vector<FileOfRun> parse_files(const std::string& name, std::string_view csv);

}  // namespace mapbed
