#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/config/settings.h"
#include "worlds/world.h"

namespace mapbed {

// A builder by name. Every builder has an option `seed`: 0 is the one of the experiments, any other
// draws another world of its kind.
struct WorldKind {
  std::string name;
  std::string about;
  std::function<std::string(const Settings&)> complete_yaml;  // all options as they hold then
  std::function<World(const Settings&)> build;
};

const std::vector<WorldKind>& world_kinds();

// Names of the world files in worlds/: a file put there is a world by its name.
std::vector<std::string> world_file_names();

// By the name of a builder or of a file in worlds/, or from a file where the name ends in ".yaml"
// (worlds/file/world_file.h). Throws InputError for an unknown name (with the nearest one) or a
// wrong setting.
World build_world(const std::string& name, const Settings& settings = {});

}  // namespace mapbed
