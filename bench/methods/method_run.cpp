#include "bench/methods/method_run.h"

#include "bench/process/process_cost.h"
#include "bench/process/stopwatch.h"

namespace mapbed {
namespace {

MethodRun run_ours(const ConfiguredMethod& method, const MethodInput& input,
                   const MethodWatch& watch) {
  const auto estimator = method.make(input.given, input.rng);
  const Stopwatch stopwatch;
  const double start = processor_time();
  for (const Measurement& measurement : input.prepared) {
    if (watch.before) watch.before(measurement, *estimator);
    estimator->add(measurement);
    if (watch.after) watch.after(measurement, *estimator);
  }
  if (watch.all_added) watch.all_added(*estimator);
  estimator->finish();
  MethodRun run{.estimate = estimator->estimate(), .cost = {}};
  run.cost.processor_seconds = processor_time() - start;
  run.cost.wall_seconds = stopwatch.seconds();
  return run;
}

}  // namespace

MethodRun run_method(const ChosenMethod& method, const MethodInput& input,
                     const MethodWatch& watch) {
  if (const ProgramMethod* program = method.program()) {
    ProgramRun run =
        run_program_method(*program, input.as_recorded, input.prepared, input.seed, input.goes_on);
    return {std::move(run.estimate), run.cost, std::move(run.kept)};
  }
  return run_ours(std::get<ConfiguredMethod>(method.what), input, watch);
}

}  // namespace mapbed
