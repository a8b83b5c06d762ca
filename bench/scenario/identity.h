#pragma once

#include <string>

#include "core/file/input_file.h"

namespace mapbed {

struct ScenarioPlan;

// One word for everything that decides what the runs give, down to the content of every file:
// scenarios that agree in it differ in their words, plots and claims alone. Whoever has it may take
// over each other's rows, where the program is the same.
std::string identity_of(const ScenarioPlan& plan);

// All files that the runs of all levels and variants are made of: worlds with plans and meshes,
// robots with sensors, logs, learned parameters. A program of somebody else's that a scenario names
// is one more of the experiment's (Configured::files).
InputFiles input_files(const ScenarioPlan& plan);

}  // namespace mapbed
