#include "sim/drivers/drivers.h"

#include "core/config/suggestion.h"
#include "core/input_error.h"
#include "sim/drivers/car_driver.h"
#include "sim/drivers/omni_driver.h"
#include "sim/drivers/scripted_driver.h"
#include "sim/drivers/turning_driver.h"

namespace mapbed {
namespace {

// A Kind is made from the simulation, the path and its options.
template <class Kind, class Options>
DriverKind kind(const std::string& name, const std::string& about, bool (*can_drive)(DriveKind)) {
  return {name, about, can_drive, [name](const Settings& settings) {
            Options options;
            apply(settings, options_of(options), "driver '" + name + "'");
            return Configured<MakeDriver>{
                to_yaml(options_of(options)),
                [options](const Simulation& simulation, const NamedPath& path) {
                  return std::make_unique<Kind>(simulation, path, options);
                }};
          }};
}

bool any(DriveKind /*drive*/) {
  return true;
}
bool turns_on_the_spot(DriveKind drive) {
  return drive != DriveKind::ackermann;
}
bool goes_sideways(DriveKind drive) {
  return drive == DriveKind::omni;
}

}  // namespace

const std::vector<DriverKind>& driver_kinds() {
  static const std::vector<DriverKind> kinds = {
      kind<ScriptedDriver, PathFollowingOptions>(
          "scripted", "follows a path as a careful operator would, who sees robot and people",
          turns_on_the_spot),
      kind<OmniDriver, OmniDriverOptions>(
          "omni", "the same on wheels that go in any direction: drives sideways too",
          goes_sideways),
      kind<CarDriver, CarDriverOptions>(
          "car", "the same with a turning circle: plans arcs, backwards where there is no room",
          any),
      kind<TurningDriver, TurningDriverOptions>(
          "turning", "scripted, and turns round on the spot at each point of the path",
          turns_on_the_spot),
  };
  return kinds;
}

const std::string& usual_driver(DriveKind drive) {
  static const std::string scripted = "scripted", omni = "omni", car = "car";
  return drive == DriveKind::omni ? omni : drive == DriveKind::ackermann ? car : scripted;
}

const DriverKind& driver_by_name(const std::string& name) {
  std::vector<std::string> names;
  for (const DriverKind& driver : driver_kinds()) {
    if (driver.name == name) return driver;
    names.push_back(driver.name);
  }
  throw InputError("unknown driver " + in_quotes(name) + "; " + suggestion(name, names));
}

Configured<MakeDriver> configure_driver(const std::string& name, const Settings& settings) {
  return (name.empty() ? driver_kinds().front() : driver_by_name(name)).configure(settings);
}

}  // namespace mapbed
