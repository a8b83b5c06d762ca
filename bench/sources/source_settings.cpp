#include "bench/sources/source_settings.h"

#include <algorithm>

namespace mapbed {
namespace {

const std::vector<std::string> kNames{"world", "robot", "path", "driver", "people", "log"};
const std::vector<std::string> kGroups{"world",    "robot", "simulation", "driver",
                                       "recorder", "log",   "faults"};

bool contains(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_of_source(const std::string& path) {
  const std::size_t dot = path.find('.');
  return dot == std::string::npos ? contains(kNames, path) : contains(kGroups, path.substr(0, dot));
}

// Without "name." in front.
Settings below(const std::string& name, const Settings& settings) {
  Settings result;
  for (Setting setting : settings) {
    if (!setting.path.starts_with(name + ".")) continue;
    setting.path.erase(0, name.size() + 1);
    result.push_back(std::move(setting));
  }
  return result;
}

bool is_recorded(const Settings& settings) {
  return last_named(settings, "log") != nullptr;
}

bool is_simulated(const Settings& settings) {
  return last_named(settings, "world") != nullptr || last_named(settings, "robot") != nullptr;
}

Settings overlaid(const Settings& common, const Settings& own) {
  const bool of_other_kind =
      (is_recorded(own) && !is_recorded(common)) || (is_simulated(own) && is_recorded(common));
  if (of_other_kind) return own;
  Settings result = common;
  result.insert(result.end(), own.begin(), own.end());
  return result;
}

}  // namespace

DividedSettings divided(const Settings& settings, const std::vector<std::string>& further_logs) {
  DividedSettings result;
  for (const Setting& setting : settings) {
    const std::string group = setting.path.substr(0, setting.path.find('.'));
    if (group != setting.path && contains(further_logs, group)) continue;
    (is_of_source(setting.path) ? result.source : result.experiment).push_back(setting);
  }
  for (const std::string& name : further_logs) {
    result.further[name] = overlaid(result.source, below(name, settings));
  }
  return result;
}

const Setting* last_named(const Settings& settings, const std::string& path) {
  const auto found = std::find_if(settings.rbegin(), settings.rend(),
                                  [&](const Setting& setting) { return setting.path == path; });
  return found == settings.rend() ? nullptr : &*found;
}

}  // namespace mapbed
