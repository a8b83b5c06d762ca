#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/config/configured.h"
#include "core/config/settings.h"
#include "core/driver.h"
#include "sim/simulation.h"
#include "worlds/world.h"

namespace mapbed {

// A driver for one drive along a path of the world. It may look at the simulation, which outlives
// it.
using MakeDriver = std::unique_ptr<Driver>(const Simulation&, const NamedPath&);

// A driver by name. A new one is a file pair in this folder and a line in the table.
struct DriverKind {
  std::string name;
  std::string about;
  bool (*can_drive)(DriveKind);
  std::function<Configured<MakeDriver>(const Settings&)> configure;
};

const std::vector<DriverKind>& driver_kinds();

// Who drives such a robot where nobody says otherwise.
const std::string& usual_driver(DriveKind drive);

// Throws InputError for an unknown name (with the nearest one).
const DriverKind& driver_by_name(const std::string& name);

// Throws InputError for an unknown name or a wrong setting; an empty name is `scripted`.
Configured<MakeDriver> configure_driver(const std::string& name, const Settings& settings = {});

}  // namespace mapbed
