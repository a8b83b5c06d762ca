#include "bench/cli/catalogue.h"

#include "algorithms/estimator.h"
#include "core/log/log_options.h"

namespace mapbed {
namespace {

std::vector<CatalogueEntry> method_entries() {
  std::vector<CatalogueEntry> entries;
  for (const Method& method : methods()) {
    entries.push_back({method.name, method.about, [&method] { return method.complete_yaml({}); }});
  }
  return entries;
}

template <class Options>
std::string defaults_of() {
  Options options;
  return to_yaml(options_of(options));
}

std::vector<CatalogueEntry> setting_entries() {
  return {{"log", "how a recorded log is read", defaults_of<LogOptions>}};
}

}  // namespace

const std::vector<CatalogueShelf>& catalogue() {
  static const std::vector<CatalogueShelf> shelves{
      {"methods", "method", method_entries},
      {"settings", "setting", setting_entries},
  };
  return shelves;
}

}  // namespace mapbed
