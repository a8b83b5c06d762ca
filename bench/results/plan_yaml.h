#pragma once

#include <string>

#include "bench/results/results.h"

namespace mapbed {

class ConfigNode;

// What was planned, as it stands under `scenario` in config.yaml, without indentation. load_plan
// makes the same Results of it again, but for Metric::when_failed.
std::string plan_yaml(const Results& plan);

// The part of it that decides what the runs give: scenarios that agree in it differ in their words,
// plots and claims alone.
std::string design_yaml(const Results& plan);

// The plan in a config.yaml: all of Results but the rows and texts. Older files have their claims
// as sentences, which are left out here. Throws InputError.
Results load_plan(const std::string& config_path);
Results plan_in(const ConfigNode& config);

}  // namespace mapbed
