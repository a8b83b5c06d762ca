#include "sim/actors/crowd_options.h"

#include <cmath>

namespace mapbed {

CrowdOptions with_people(CrowdOptions options, const CrowdRules& rules, int people) {
  const int total = rules.walkers + rules.standing + rules.blockers;
  const auto rounded = [&](int part) {
    return total > 0 ? static_cast<int>(std::lround(static_cast<double>(people) * part / total))
                     : 0;
  };
  options.blockers = rounded(rules.blockers);
  options.standing = rounded(rules.blockers + rules.standing) - options.blockers;
  options.walkers = people - options.blockers - options.standing;
  return options;
}

}  // namespace mapbed
