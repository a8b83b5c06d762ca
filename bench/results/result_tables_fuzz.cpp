// Whatever stands in the tables of a result: rows of what was planned, or an InputError. The first
// byte says which table it is.

#include <array>

#include "bench/results/result_tables.h"
#include "bench/results/results.h"
#include "bench/results/sweep.h"
#include "core/check.h"
#include "core/input_error.h"
#include "core/testing/fuzz_input.h"

namespace {

using namespace mapbed;

Results some_plan() {
  Results plan{.id = "fuzz", .experiment = "slam", .seeds = 2};
  plan.axes = {axis_of("world", {"a, b", "c"})};
  plan.levels = levels_of(plan.axes);
  plan.variants = {"raw", "matched, \"twice\""};
  plan.metrics = {{"error", Unit::meter, ""}, {"success", Unit::none, ""}};
  plan.series_metrics = {{"error_over_time", Unit::meter, ""}};
  return plan;
}

void read(char table, std::string_view csv) {
  static const Results plan = some_plan();
  switch (table) {
    case 'r': {
      Results results = plan;
      results.runs = parse_runs("runs.csv", csv, plan);
      const std::string text = runs_csv(results);
      results.runs = parse_runs("again.csv", text, plan);
      CHECK(runs_csv(results) == text);
      return;
    }
    case 's':
      return (void)parse_summary("summary.csv", csv, plan);
    case 'x':
      return (void)parse_series("series.csv", csv, plan);
    case 'v':
      return (void)parse_verdicts("claims.csv", csv, false);
    case 'c':
      return (void)parse_costs("cost.csv", csv);
    case 'f':
      return (void)parse_files("files.csv", csv);
    default:
      return;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  try {
    read(static_cast<char>(data[0]), fuzz_text(data + 1, size - 1));
  } catch (const InputError&) {
    return 0;
  }
  return 0;
}
