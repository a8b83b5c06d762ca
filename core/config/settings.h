#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/config/option.h"
#include "core/input_error.h"

namespace mapbed {

// One value as it was written, with the place where it stands; the path of a file is written whole.
struct Setting {
  std::string path;  // "robot.odometry.rotation_sigma"
  std::string text;  // "2 deg", "[1 cm, 2 cm]", "counting"
  SourceLocation place;
};

// What a file or `--set path=value` says; only what differs from the defaults.
using Settings = std::vector<Setting>;

// "a.b=value" from the command line. Throws InputError where there is no '='.
Setting parse_setting(const std::string& assignment);

// All leaves of a YAML file as dotted paths. Throws InputError on YAML errors and repeated keys.
Settings load_settings(const std::string& yaml_path);

// Writes the settings into the options they name, the later of two winning. Throws InputError on an
// unknown path (with its new name, or the nearest one), a wrong unit, a value that is not a number,
// NaN, or the like. `context` names the thing that has the options: "unknown key 'x' in
// scan_matching".
void apply(const Settings& settings, const OptionList& options, const std::string& context);

// The complete configuration, defaults included, as YAML with units and the meaning as comments.
std::string to_yaml(const OptionList& options);

// Nested options, as to_yaml() has them, with dotted paths below `group` (may be empty), so that
// they can stand beside the name of what has them.
std::string dotted(const std::string& group, std::string_view yaml);

// Every line of a text behind so many blanks, as YAML has what belongs to a key.
std::string indented(std::string_view yaml, int blanks = 2);

}  // namespace mapbed
