#include "bench/methods/chosen_method.h"

#include <algorithm>

#include "core/data_path.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

bool is_ours(const std::string& name) {
  return std::any_of(methods().begin(), methods().end(),
                     [&](const Method& method) { return method.name == name; });
}

// As method_by_name, but tells where the name stands.
void check_method(const std::string& name, const SourceLocation& place) {
  if (is_ours(name) || is_program_method(name)) return;
  std::vector<std::string> names = program_method_names();
  for (const Method& method : methods()) names.push_back(method.name);
  std::sort(names.begin(), names.end());
  throw InputError(place, "unknown method " + in_quotes(name),
                   name_or_path_suggestion(name, names, {.place = place, .endings = {".yaml"}}));
}

const Setting* estimator_in(const Settings& settings) {
  const Setting* last = nullptr;
  for (const Setting& setting : settings) {
    if (setting.path == "estimator") last = &setting;
  }
  return last;
}

}  // namespace

ChosenMethod choose_method(const std::string& name_or_path, const Settings& settings,
                           const SourceLocation& place) {
  check_method(name_or_path, place);
  if (is_ours(name_or_path)) {
    const Method& ours = method_by_name(name_or_path);
    ConfiguredMethod method = ours.configure(settings);
    return {.name = ours.name,
            .about = ours.about,
            .complete_yaml = method.complete_yaml,
            .files = method.files,
            .what = std::move(method),
            .labels_beams = ours.labels_beams,
            .has_graph = ours.has_graph,
            .needs_odometry = ours.needs_odometry,
            .needs_map = ours.needs_map};
  }
  ProgramMethod program = load_program_method(name_or_path, settings);
  return {program.name, program.about, program.complete_yaml(), program.input_files,
          std::move(program)};
}

MethodSettings divided_by_method(const Settings& settings) {
  MethodSettings result;
  for (const Method& method : methods()) result.of_methods.emplace_back(method.name, Settings{});
  for (const std::string& name : program_method_names())
    result.of_methods.emplace_back(name, Settings{});
  const Setting* estimator = estimator_in(settings);
  if (estimator != nullptr && estimator->text.find('/') != std::string::npos) {
    result.of_methods.emplace_back(program_method_name(estimator->text), Settings{});
  }
  for (Setting setting : settings) {
    const auto method =
        std::find_if(result.of_methods.begin(), result.of_methods.end(),
                     [&](const auto& m) { return setting.path.starts_with(m.first + "."); });
    if (method == result.of_methods.end()) {
      result.own.push_back(std::move(setting));
    } else {
      setting.path.erase(0, method->first.size() + 1);
      method->second.push_back(std::move(setting));
    }
  }
  return result;
}

ChosenMethod chosen_method(const std::string& estimator, const MethodSettings& settings) {
  const Setting* named = estimator_in(settings.own);
  const SourceLocation place = named == nullptr ? SourceLocation{} : named->place;
  check_method(estimator, place);
  const std::string chosen = is_ours(estimator) ? estimator : program_method_name(estimator);
  Settings of_chosen;
  for (const auto& [name, of_method] : settings.of_methods) {
    if (name == chosen) {
      of_chosen.insert(of_chosen.end(), of_method.begin(), of_method.end());
    } else if (is_ours(name)) {
      (void)method_by_name(name).configure(of_method);
    } else if (!of_method.empty() && is_program_method(name)) {
      (void)load_program_method(name, of_method);
    }
  }
  return choose_method(estimator, of_chosen, place);
}

std::string method_yaml(const ChosenMethod& method) {
  const std::string yaml = method.name + ":\n" + indented(method.complete_yaml, 2);
  if (method.filter.empty()) return yaml;
  return yaml + "people_filter:\n  method: " + method.filter + "\n" +
         indented(method.filter_yaml, 2);
}

}  // namespace mapbed
