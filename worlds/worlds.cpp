#include "worlds/worlds.h"

#include "core/data_path.h"
#include "core/input_error.h"
#include "worlds/corridor/corridor.h"
#include "worlds/file/world_file.h"
#include "worlds/loop_corridor/loop_corridor.h"
#include "worlds/mine/mine_plan.h"
#include "worlds/museum/museum.h"
#include "worlds/office/office.h"

namespace mapbed {
namespace {

template <class Options>
WorldKind kind(const std::string& name, const std::string& about, World (*build)(const Options&),
               const Options& defaults = {}) {
  return {name, about, [=](const Settings& settings) {
            Options options = defaults;
            apply(settings, options_of(options), "world '" + name + "'");
            return Configured<World()>{to_yaml(options_of(options)), [=] {
                                         World world = build(options);
                                         world.name = name;  // a builder can make several kinds
                                         return world;
                                       }};
          }};
}

}  // namespace

const std::vector<WorldKind>& world_kinds() {
  static const std::vector<WorldKind> kinds = {
      kind("corridor", "corridor of 25 m x 4 m with doors that open and close", build_corridor),
      kind("hall_loop", "wide corridor round a block, 32 m x 10 m", build_loop_corridor,
           hall_loop()),
      kind("loop_corridor", "corridor round a block, 50 m x 12 m", build_loop_corridor),
      kind("mine_plan", "corridors of a mine with rough walls, 250 m long, with several loops",
           build_mine_plan),
      kind("museum", "hall of 30 m x 45 m with columns, showcases, niches", build_museum),
      kind("nested_loops", "a small corridor loop beside a large one", build_loop_corridor,
           nested_loops()),
      kind("office", "corridor ring with rooms, furniture and a wall of glass", build_office),
      kind("office_corridor", "narrow office corridor with a route of 74 m", build_corridor,
           office_corridor()),
  };
  return kinds;
}

std::vector<std::string> world_file_names() {
  return data_names("worlds");
}

Configured<World()> configure_world(const std::string& name, const Settings& settings) {
  if (name.ends_with(".yaml")) return configure_world_file(name, settings);
  std::vector<std::string> names;
  for (const WorldKind& world : world_kinds()) {
    if (world.name == name) return world.configure(settings);
    names.push_back(world.name);
  }
  for (const std::string& file : world_file_names()) {
    if (file == name) {
      return configure_world_file(find_data_file("world", "worlds", name).string(), settings);
    }
    names.push_back(file);
  }
  throw InputError("unknown world '" + name + "'; " + name_or_path_suggestion(name, names));
}

World build_world(const std::string& name, const Settings& settings) {
  return configure_world(name, settings).make();
}

}  // namespace mapbed
