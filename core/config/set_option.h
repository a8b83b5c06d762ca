#pragma once

#include "core/config/config_node.h"
#include "core/config/option.h"

namespace mapbed {

// Writes a node into one option. Throws InputError on a wrong kind, unit, number or bound.
void set_option(const Option& option, const ConfigNode& node);

// The option's value as YAML with its unit, which set_option reads as exactly this value.
std::string option_text(const Option& option);

bool is_list(const Option& option);

}  // namespace mapbed
