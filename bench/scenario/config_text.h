#pragma once

#include <string>

namespace mapbed {

struct ScenarioPlan;

// config.yaml: what was planned under `scenario`, and under `runs`, for each variant at the first
// level, every option that holds, defaults included. Later changes of defaults cannot rewrite it.
std::string config_text(const ScenarioPlan& plan);

// The part of it that decides what the runs give: scenarios that agree in it differ in their words,
// plots and claims alone.
std::string identity_text(const ScenarioPlan& plan);

}  // namespace mapbed
