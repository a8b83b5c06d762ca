#pragma once

#include <string>

#include "bench/results/results.h"

namespace mapbed {

struct ScenarioPlan;

// config.yaml: what was planned under `scenario`, and under `runs`, for each variant at the first
// level, every option that holds, defaults included. Later changes of defaults cannot rewrite it.
std::string config_text(const ScenarioPlan& plan);

// The part of it that decides what the runs give: scenarios that agree in it differ in their words,
// plots and claims alone.
std::string identity_text(const ScenarioPlan& plan);

// What was planned, from such a file: all of Results but the rows. Throws InputError.
Results load_planned(const std::string& config_path);

}  // namespace mapbed
