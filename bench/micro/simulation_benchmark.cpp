#include <benchmark/benchmark.h>

#include "robots/robot.h"
#include "sim/drivers/scripted_driver.h"
#include "sim/noise/laser_noise.h"
#include "sim/simulation.h"
#include "worlds/worlds.h"

namespace mapbed {
namespace {

// A museum with people and a 180-beam laser at 5 Hz, everything on: physics, legs, mixed pixels,
// mirror sweep, glass, noise, labels. One iteration is one simulated second.
void simulate_museum(benchmark::State& state) {
  const World world = build_world("museum");
  const Robot robot = load_robot("pioneer");
  const MountedLaser laser = lasers_of(robot).front();
  const Rng rng(1);
  const SimulationOptions options{
      .actors = {
          .people = {.walkers = static_cast<int>(state.range(0)), .standing = 0, .blockers = 0}}};
  Simulation simulation(world, robot, start_of(world.paths.front()), options, rng);
  ScriptedDriver driver(simulation, world.paths.front());
  std::uint64_t number = 0;
  for (auto _ : state) {
    for (int step = 1; step <= 100; ++step) {
      simulation.step(driver.command(simulation.now().time));
      if (step % 20 != 0) continue;
      const double start = simulation.now().time - 0.05;
      const Simulation::Sweep sweep = simulation.sweep(0, start, number++);
      benchmark::DoNotOptimize(with_noise(sweep.ideal, laser, rng).ranges.data());
    }
  }
  state.counters["times_real_time"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(simulate_museum)->Arg(0)->Arg(15)->Arg(50)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace mapbed
