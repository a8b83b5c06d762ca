#pragma once

namespace mapbed {

class ConfigNode;
struct Scenario;

// The scenario's own log, among the further ones of a config.yaml (config_text.h).
inline constexpr const char* kConfigSource = "source";

// Whether a file is a config.yaml, and the scenario in it. Throws InputError for one of an older
// program, which cannot be run.
bool is_config(const ConfigNode& file);
Scenario scenario_in(const ConfigNode& config);

}  // namespace mapbed
