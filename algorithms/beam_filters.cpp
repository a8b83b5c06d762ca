#include "algorithms/beam_filters.h"

#include <type_traits>

#include "algorithms/people/learned_people.h"
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

// A wrong name is told with its place.
InputFile learned_file_of(const std::string& name, const Settings& settings) {
  try {
    return learned_people_file(name);
  } catch (const InputError& error) {
    for (const Setting& setting : settings) {
      if (setting.path == "learned") throw InputError(setting.place, error.what());
    }
    throw;
  }
}

// One that follows people, by what was learned of them.
template <class Class>
BeamFilterEntry people_filter(const std::string& name, const std::string& about) {
  return {name, about, [name](const Settings& settings) -> ConfiguredFilter {
            typename Class::Options options;
            apply(settings, options_of(options), name);
            InputFiles files{learned_file_of(options.learned, settings)};
            const auto learned =
                std::make_shared<const LearnedPeople>(load_learned_people(options.learned));
            return {to_yaml(options_of(options)),
                    [options, learned](Rng rng) {
                      return std::unique_ptr<BeamFilter>(new Class(options, learned, rng));
                    },
                    std::move(files)};
          }};
}

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
      people_filter<PeopleFilter>(
          "people", "people who are followed by joint probabilistic data association, chapter 3"),
      people_filter<KalmanPeopleFilter>(
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
