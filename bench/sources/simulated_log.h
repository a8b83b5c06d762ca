#pragma once

#include <functional>
#include <string>

#include "bench/sources/simulate.h"

namespace mapbed {

// What `mapbed simulate` needs besides.

// Told again and again how far the robot has driven [m].
using Driven = std::function<void(double meters)>;

// As run_simulation.
SimulationResult run_watched_simulation(PreparedSimulation simulation, std::uint64_t seed,
                                        const Driven& driven);

}  // namespace mapbed
