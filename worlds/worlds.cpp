#include "worlds/worlds.h"

#include "core/config/suggestion.h"
#include "core/input_error.h"
#include "worlds/office/office.h"

namespace mapbed {
namespace {

template <class Options>
WorldKind kind(const std::string& name, const std::string& about, World (*build)(const Options&)) {
  const auto options_with = [name](const Settings& settings) {
    Options options;
    apply(settings, options_of(options), "world '" + name + "'");
    return options;
  };
  return {
      name, about,
      [options_with](const Settings& settings) {
        Options options = options_with(settings);
        return to_yaml(options_of(options));
      },
      [options_with, build](const Settings& settings) { return build(options_with(settings)); }};
}

}  // namespace

const std::vector<WorldKind>& world_kinds() {
  static const std::vector<WorldKind> kinds = {
      kind("office", "corridor ring with rooms, furniture and a wall of glass", build_office),
  };
  return kinds;
}

World build_world(const std::string& name, const Settings& settings) {
  std::vector<std::string> names;
  for (const WorldKind& world : world_kinds()) {
    if (world.name == name) return world.build(settings);
    names.push_back(world.name);
  }
  throw InputError("unknown world '" + name + "'; " + suggestion(name, names));
}

}  // namespace mapbed
