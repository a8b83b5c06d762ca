#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/config/configured.h"
#include "core/config/settings.h"
#include "worlds/world.h"

namespace mapbed {

// A builder by name. Every builder has an option `seed`: 0 is the one of the experiments, any other
// draws another world of its kind.
struct WorldKind {
  std::string name;
  std::string about;
  std::function<Configured<World()>(const Settings&)> configure;
};

const std::vector<WorldKind>& world_kinds();

// Names of the world files in worlds/: a file put there is a world by its name.
std::vector<std::string> world_file_names();

// By the name of a builder or of a file in worlds/, or from a file where the name ends in ".yaml"
// (worlds/file/world_file.h), which is read now and never again. Throws InputError for an unknown
// name (with the nearest one) or a wrong setting; of a builder that cannot make what is asked for,
// only make() says so.
Configured<World()> configure_world(const std::string& name, const Settings& settings = {});

World build_world(const std::string& name, const Settings& settings = {});  // at once

}  // namespace mapbed
