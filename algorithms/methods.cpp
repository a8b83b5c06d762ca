#include "algorithms/methods.h"

#include <type_traits>

#include "algorithms/dynamic_em/dynamic_em.h"
#include "algorithms/lazy_association/lazy_slam.h"
#include "algorithms/localization_method.h"
#include "algorithms/motion/motion_learning.h"
#include "algorithms/odometry_estimator.h"
#include "algorithms/rbpf/grid_slam.h"
#include "algorithms/scan_matching/incremental_matcher.h"
#include "algorithms/submaps/graph_slam.h"
#include "core/config/suggestion.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

// Of what each is allowed, but not with the other.
void check_together(const GridSlamOptions& options, const Settings& settings) {
  if (options.proposal != Proposal::odometry || options.matcher.use_odometry) return;
  SourceLocation place;
  for (const Setting& setting : settings) {
    if (setting.path == "proposal" || setting.path == "matcher.use_odometry") place = setting.place;
  }
  throw InputError(place,
                   "proposal 'odometry' needs the odometry that matcher.use_odometry leaves out",
                   "choose proposal 'scan_matching' or 'improved', or leave use_odometry as it is");
}

// The errors of motions may be learned ones, by name.
template <class Options>
concept HasMotionModels = requires(Options o) {
  o.matching_errors;
};
template <class Options>
constexpr bool kHasMotionModels = HasMotionModels<Options>;
template <class Options>
requires HasMotionModels<decltype(Options::chain)>
constexpr bool kHasMotionModels<Options> = true;

// Of options that name files. A wrong name is told by options_from.
template <class Options>
InputFiles files_named_in(const Settings& settings) {
  if constexpr (kHasMotionModels<Options>) return learned_model_files(settings);
  return {};
}

template <class Options>
Options options_from(Options options, const Settings& settings, const std::string& name) {
  if constexpr (kHasMotionModels<Options>) {
    apply(with_learned_models(settings), options_of(options), name);
  } else {
    apply(settings, options_of(options), name);
  }
  return options;
}

GridSlamOptions options_from(GridSlamOptions options, const Settings& settings,
                             const std::string& name) {
  apply(with_learned_models(settings), options_of(options), name);
  check_together(options, settings);
  return options;
}

// A method whose class takes its options, and its own stream of chance where it needs one.
template <class Class, class Options>
Method method(const std::string& name, const std::string& about, const Options& defaults = {}) {
  return {name, about, [name, defaults](const Settings& settings) -> ConfiguredMethod {
            Options options = options_from(defaults, settings, name);
            InputFiles files = files_named_in<Options>(settings);
            const std::string yaml = to_yaml(options_of(options));
            return {yaml,
                    [options](const Given& given, [[maybe_unused]] Rng rng) {
                      const Pose2 start = given.start.value_or(Pose2{});
                      if constexpr (std::is_constructible_v<Class, Options, Rng, Pose2>) {
                        return std::unique_ptr<Estimator>(new Class(options, rng, start));
                      } else {
                        return std::unique_ptr<Estimator>(new Class(options, start));
                      }
                    },
                    std::move(files)};
          }};
}

// The method that registers for chapter 4, and the settings of both apart.
struct EmSettings {
  Setting registers{"path", "scan_matching", {}};
  Settings of_em = {};
  Settings of_method = {};  // that registers, without its name in front
};

EmSettings divided_em_settings(const Settings& settings) {
  EmSettings divided;
  for (const Setting& setting : settings) {
    if (setting.path == "path") divided.registers = setting;
  }
  const std::string group = divided.registers.text + ".";
  for (const Setting& setting : settings) {
    if (setting.path == "path") continue;
    const bool is_of_method = setting.path.starts_with(group);
    Setting& taken = (is_of_method ? divided.of_method : divided.of_em).emplace_back(setting);
    if (is_of_method) taken.path.erase(0, group.size());
  }
  return divided;
}

ConfiguredMethod configure_em(const std::string& name, const Settings& settings) {
  const EmSettings divided = divided_em_settings(settings);
  DynamicEmOptions options;
  apply(divided.of_em, options_of(options), name);
  const std::string& registers = divided.registers.text;
  if (registers == name) {
    throw InputError(divided.registers.place, name + " cannot find its own path",
                     "choose scan_matching or rbpf");
  }
  const ConfiguredMethod method = method_by_name(registers).configure(divided.of_method);
  const std::string yaml = to_yaml(options_of(options)) + "path: " + registers +
                           "  # the method that registers the scans, its options below\n" +
                           registers + ":\n" + indented(method.complete_yaml);
  return {yaml,
          [options, method](const Given& given, Rng rng) {
            const auto make_method = [method, given, rng] { return method.make(given, rng); };
            return std::unique_ptr<Estimator>(new DynamicEm(options, make_method));
          },
          method.files};
}

Method em_method() {
  const std::string name = "em";
  return {name,
          "expectation maximisation over what is static, with any of the others for the path, "
          "chapter 4",
          [name](const Settings& settings) { return configure_em(name, settings); }, true};
}

Method with_graph(Method method) {
  method.has_graph = true;
  return method;
}

Method odometry_method() {
  Method result =
      method<OdometryEstimator, OdometryOptions>("odometry", "dead reckoning alone, the baseline");
  result.needs_odometry = true;
  return result;
}

}  // namespace

const std::vector<Method>& methods() {
  static const std::vector<Method> table{
      odometry_method(),
      method<IncrementalMatcher, IncrementalMatcherOptions>(
          "scan_matching", "incremental scan matching by hill climbing, section 2.3"),
      method<IncrementalMatcher, IncrementalMatcherOptions>(
          "correlative", "incremental scan matching by correlative search before each climb",
          {.alignment = Alignment::correlative}),
      method<IncrementalMatcher, IncrementalMatcherOptions>(
          "icp", "incremental scan matching by point-to-line ICP", {.alignment = Alignment::icp}),
      method<GridSlam, GridSlamOptions>(
          "rbpf", "Rao-Blackwellised particle filter with scan matching, chapter 5"),
      method<GridSlam, GridSlamOptions>(
          "maximum_likelihood",
          "the same filter, going on with its best particle alone after a loop, section 5.4.2",
          {.best_only_after_loop = true}),
      with_graph(method<GraphSlam, GraphSlamOptions>(
          "graph", "scan matching, local maps that close loops, and a robust pose graph")),
      with_graph(method<LazySlam, LazySlamOptions>(
          "lazy",
          "local maps whose data association is taken back where it turns out wrong, "
          "chapter 6")),
      em_method(),
      localization_method(),
  };
  return table;
}

const Method& method_by_name(const std::string& name) {
  std::vector<std::string> names;
  for (const Method& method : methods()) {
    if (method.name == name) return method;
    names.push_back(method.name);
  }
  throw InputError({}, "unknown method '" + name + "'", suggestion(name, names));
}

}  // namespace mapbed
