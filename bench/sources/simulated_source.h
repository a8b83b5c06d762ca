#pragma once

#include <cstdint>
#include <memory>

#include "bench/sources/log_source.h"

namespace mapbed {

// Of settings without 'log'. Throws InputError.
SourcePlan plan_simulated(const Settings& settings, SimulationParts& parts);

std::unique_ptr<LogSource> open_simulated(const PreparedSimulation& simulation, std::uint64_t seed,
                                          const GoesOn& goes_on);

}  // namespace mapbed
