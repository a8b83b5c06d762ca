#include "bench/results/cost_claims.h"

#include <algorithm>
#include <limits>

#include "bench/results/summary.h"

namespace mapbed {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// In the order of the table.
std::vector<double> values_of(const CostRow& cost) {
  const bool is_told = cost.method_seconds > 0.0;
  return {cost.seconds, is_told ? cost.method_seconds : kNone,
          is_told ? cost.recorded_seconds / cost.method_seconds : kNone};
}

}  // namespace

const std::vector<Metric>& cost_metrics() {
  static const std::vector<Metric> table{
      {"run_seconds", Unit::second, "processor time of a run, without recording"},
      {"method_seconds", Unit::second, "processor time of the method alone"},
      {"real_time_factor", Unit::none, "recorded time over the method's processor time"},
  };
  return table;
}

bool is_about_cost(const Claim& claim) {
  const std::vector<Metric>& table = cost_metrics();
  return std::any_of(table.begin(), table.end(),
                     [&](const Metric& metric) { return metric.name == claim.metric; });
}

Results with_costs_as_metrics(const Results& results) {
  Results costs = results;
  costs.metrics = cost_metrics();
  for (RunRow& run : costs.runs) {
    const auto cost = std::find_if(results.costs.begin(), results.costs.end(),
                                   [&](const CostRow& row) { return row.run == run.run; });
    run.values = cost == results.costs.end() ? std::vector<double>(costs.metrics.size(), kNone)
                                             : values_of(*cost);
  }
  costs.summary = summary_of(costs);
  return costs;
}

}  // namespace mapbed
