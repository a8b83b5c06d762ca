#include "bench/methods/people_filter.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "algorithms/beam_filters.h"
#include "algorithms/filtered_estimator.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr std::string_view kGroup = "people_filter";
constexpr std::string_view kDefault = "people";
constexpr std::string_view kNone = "none";

bool concerns_filter(const Setting& setting) {
  return setting.path == kGroup || setting.path.starts_with(std::string(kGroup) + ".");
}

// Its name, taken out of the options, and where it stands.
Setting taken_name(Settings& of_filter) {
  Setting name{"method", std::string(kDefault), {}};
  Settings options;
  for (Setting& setting : of_filter) {
    (setting.path == "method" ? name : options.emplace_back()) = std::move(setting);
  }
  of_filter = std::move(options);
  return name;
}

}  // namespace

Settings taken_people_filter(Settings& settings) {
  const auto first = std::stable_partition(settings.begin(), settings.end(),
                                           [](const Setting& s) { return !concerns_filter(s); });
  Settings taken(std::make_move_iterator(first), std::make_move_iterator(settings.end()));
  settings.erase(first, settings.end());
  for (Setting& setting : taken) {
    const bool is_name = setting.path == kGroup;
    setting.path = is_name ? "method" : setting.path.substr(kGroup.size() + 1);
  }
  std::erase_if(taken, [](const Setting& s) { return s.path == "method" && s.text == "{}"; });
  return taken;
}

ChosenMethod with_people_filter(ChosenMethod method, const Settings& of_filter) {
  if (of_filter.empty()) return method;
  Settings options = of_filter;
  const Setting name = taken_name(options);
  if (name.text == kNone) {
    if (options.empty()) return method;
    throw InputError(options.front().place, in_quotes(options.front().path) +
                                                " is set of a people filter, but there is none");
  }
  const BeamFilterEntry& entry = beam_filter_by_name(name.text, name.place);
  const ConfiguredFilter filter = entry.configure(options);
  if (method.program() != nullptr) {
    throw InputError(name.place,
                     method.name + " is a program of its own and takes no people filter",
                     "clean the log first: 'mapbed map LOG --people-filter " + name.text +
                         "' writes cleaned.log");
  }
  auto& unfiltered = std::get<ConfiguredMethod>(method.what);
  unfiltered.make = [make = std::move(unfiltered.make), filter](const Given& given, Rng rng) {
    return std::unique_ptr<Estimator>(
        new FilteredEstimator(make(given, rng), filter.make(rng.stream("people_filter"))));
  };
  method.files.insert(method.files.end(), filter.files.begin(), filter.files.end());
  method.filter = name.text;
  method.labels_beams = true;
  method.filter_yaml = filter.complete_yaml;
  return method;
}

}  // namespace mapbed
