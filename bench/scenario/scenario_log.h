#pragma once

#include <string>

#include "bench/scenario/scenario.h"
#include "bench/sources/simulate.h"

namespace mapbed {

// What a scenario's runs simulate, as it is recorded for them with the seed of each. Throws
// InputError where they have more than one log: one variant is then to be chosen by its name, and
// one value of each axis by ScenarioChoice::settings. Empty: any variant.
PreparedSimulation simulation_in(const Scenario& scenario, const std::string& variant = "");

}  // namespace mapbed
