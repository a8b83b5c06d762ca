#include "sim/drivers/drivers.h"

#include "core/config/suggestion.h"
#include "core/input_error.h"
#include "sim/drivers/scripted_driver.h"

namespace mapbed {
namespace {

// A Kind is made from the simulation, the path and its options.
template <class Kind, class Options>
DriverKind kind(const std::string& name, const std::string& about) {
  return {name, about, [name](const Settings& settings) {
            Options options;
            apply(settings, options_of(options), "driver '" + name + "'");
            return Configured<MakeDriver>{
                to_yaml(options_of(options)),
                [options](const Simulation& simulation, const NamedPath& path) {
                  return std::make_unique<Kind>(simulation, path, options);
                }};
          }};
}

}  // namespace

const std::vector<DriverKind>& driver_kinds() {
  static const std::vector<DriverKind> kinds = {
      kind<ScriptedDriver, ScriptedDriverOptions>(
          "scripted", "follows a path as a careful operator would, who sees robot and people"),
  };
  return kinds;
}

Configured<MakeDriver> configure_driver(const std::string& name, const Settings& settings) {
  if (name.empty()) return driver_kinds().front().configure(settings);
  std::vector<std::string> names;
  for (const DriverKind& driver : driver_kinds()) {
    if (driver.name == name) return driver.configure(settings);
    names.push_back(driver.name);
  }
  throw InputError("unknown driver " + in_quotes(name) + "; " + suggestion(name, names));
}

}  // namespace mapbed
