#include "algorithms/beam_filters.h"

#include <type_traits>

#include "algorithms/people/leg_filter.h"
#include "algorithms/people/tracking_filter.h"
#include "algorithms/segments/segment_filter.h"
#include "algorithms/visibility/ever_free.h"
#include "algorithms/visibility/saturated_map.h"
#include "algorithms/visibility/visibility_vote.h"
#include "core/config/suggestion.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

// A filter whose class takes its options, and its own stream of chance where it needs one.
template <class Class, class Options>
BeamFilterEntry filter(const std::string& name, const std::string& about,
                       const Options& defaults = {}) {
  return {name, about, [name, defaults](const Settings& settings) -> ConfiguredFilter {
            Options options = defaults;
            apply(settings, options_of(options), name);
            return {to_yaml(options_of(options)), [options]([[maybe_unused]] Rng rng) {
                      if constexpr (std::is_constructible_v<Class, Options, Rng>) {
                        return std::unique_ptr<BeamFilter>(new Class(options, rng));
                      } else {
                        return std::unique_ptr<BeamFilter>(new Class(options));
                      }
                    }};
          }};
}

}  // namespace

const std::vector<BeamFilterEntry>& beam_filters() {
  static const std::vector<BeamFilterEntry> table{
      filter<PeopleFilter, PeopleFilter::Options>(
          "people", "people who are followed by joint probabilistic data association, chapter 3"),
      filter<KalmanPeopleFilter, KalmanPeopleFilter::Options>(
          "kalman", "people who are followed by Kalman filters, each with the nearest feature"),
      filter<LegFilter, LegFilterOptions>("legs", "legs that moved, without a tracker, 3.4.3"),
      filter<EverFree, EverFreeOptions>(
          "ever_free", "whatever is seen where a place was ever surely free, as DUFOMap does"),
      filter<SaturatedMap, SaturatedMapOptions>(
          "saturated_map", "what is seen where an occupancy map that forgets is free in the end"),
      filter<SegmentFilter, SegmentFilterOptions>(
          "segments", "whatever moves, by segments of scans that are followed"),
      filter<VisibilityVote, VisibilityVoteOptions>("visibility_vote",
                                                    "what more scans see through than see"),
  };
  return table;
}

const BeamFilterEntry& beam_filter_by_name(const std::string& name, const SourceLocation& place) {
  std::vector<std::string> names;
  for (const BeamFilterEntry& entry : beam_filters()) {
    if (entry.name == name) return entry;
    names.push_back(entry.name);
  }
  throw InputError(place, "unknown people filter " + in_quotes(name), suggestion(name, names));
}

}  // namespace mapbed
