#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "algorithms/beam_filter.h"
#include "core/config/configured.h"
#include "core/config/settings.h"
#include "core/random.h"

namespace mapbed {

using ConfiguredFilter = Configured<std::unique_ptr<BeamFilter>(Rng)>;

// A filter by name. `configure` binds settings to its options; it throws InputError on a wrong one.
struct BeamFilterEntry {
  std::string name;
  std::string about;
  std::function<ConfiguredFilter(const Settings&)> configure;
};

const std::vector<BeamFilterEntry>& beam_filters();

// Throws InputError for an unknown name, which stands at `place`, with the nearest one.
const BeamFilterEntry& beam_filter_by_name(const std::string& name,
                                           const SourceLocation& place = {});

}  // namespace mapbed
