#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/config/settings.h"

namespace mapbed {

// Settings of a scenario by whom they concern.
struct DividedSettings {
  // Where the log comes from: world, robot, path, people, log and what stands below them,
  // simulation.…, driver.…, recorder.…, and faults.… that are put into it.
  Settings source;
  // The same of further logs, by name: those of the scenario's own log, and over them what stands
  // below the name ("mapping.path"). A further log of the other kind, recorded beside a simulated
  // one or the other way round, has what stands below its name alone.
  std::map<std::string, Settings> further;
  Settings experiment;  // all others
};

DividedSettings divided(const Settings& settings,
                        const std::vector<std::string>& further_logs = {});

// The last setting of this path; null where there is none.
const Setting* last_named(const Settings& settings, const std::string& path);

}  // namespace mapbed
