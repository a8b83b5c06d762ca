#pragma once

#include <string>
#include <vector>

#include "core/file/input_file.h"

namespace mapbed {

// The files that something was made of, as they stand in a config.yaml under `files`; by paths that
// are the same on every machine where a file is one of the program's or lies below MAPBED_DATA.
// Empty where there are none.
std::string files_yaml(const InputFiles& files);

// Those that a config.yaml names and that have another content in `now`, as files_yaml names them.
// None where there is no such file, or it names none.
std::vector<std::string> changed_files(const std::string& config_path, const InputFiles& now);

// The same in words: "a.yaml, b.yaml changed since x/config.yaml was written"; empty where none
// did.
std::string told_changes(const std::string& config_path, const InputFiles& now);

}  // namespace mapbed
