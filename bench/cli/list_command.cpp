#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "bench/cli/catalogue.h"
#include "bench/cli/command_line.h"
#include "bench/cli/commands.h"
#include "bench/cli/describe/file_text.h"
#include "bench/sources/chosen_log.h"
#include "core/config/permitted_values.h"
#include "core/config/settings.h"
#include "core/config/suggestion.h"
#include "core/data_path.h"
#include "core/file/tokens.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

int list(const std::string& kind, bool about) {
  for (const CatalogueShelf& shelf : catalogue()) {
    if (!kind.empty() && shelf.kind != kind) continue;
    if (kind.empty()) fmt::print("{}\n", shelf.kind);
    for (const CatalogueEntry& entry : shelf.entries()) {
      const bool specified = about && !entry.specification.empty();
      fmt::print("{}{:<24} {}{}{}\n", kind.empty() ? "  " : "", entry.name, entry.about,
                 specified ? ": " : "", specified ? entry.specification : "");
    }
  }
  return kDone;
}

void check_kind(const std::string& kind) {
  std::vector<std::string> kinds;
  for (const CatalogueShelf& shelf : catalogue()) kinds.push_back(shelf.kind);
  if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) {
    throw InputError({}, "there are no '" + kind + "' to list", suggestion(kind, kinds));
  }
}

// All options of that name, or whose path ends with it, a line each with what has them.
std::string options_called(const std::string& name) {
  std::string text;
  for (const CatalogueShelf& shelf : catalogue()) {
    const std::vector<std::string> with_options{"experiments", "drivers", "methods",
                                                "filters",     "faults",  "settings"};
    if (std::count(with_options.begin(), with_options.end(), shelf.kind) == 0) continue;
    for (const CatalogueEntry& entry : shelf.entries()) {
      std::string yaml = entry.describe();
      const std::size_t options = yaml.find("options:\n");
      if (options != std::string::npos) yaml.erase(0, options + 9);
      const std::string lines = dotted("", yaml);
      for (std::string_view rest = lines; !rest.empty();) {
        const std::string line(next_line(rest));
        const std::string path = line.substr(0, line.find(':'));
        if (path == name || path.ends_with("." + name)) {
          text += shelf.one + " " + entry.name + ": " + line + "\n";
        }
      }
    }
  }
  return text;
}

// Things of several kinds may have one name: all are shown.
int describe(const std::string& name) {
  const PermittedValuesShown permitted;
  std::vector<std::string> names;
  bool found = false;
  for (const CatalogueShelf& shelf : catalogue()) {
    for (const CatalogueEntry& entry : shelf.entries()) {
      names.push_back(entry.name);
      if (entry.name != name) continue;
      fmt::print("{}{} ({}): {}\n{}", found ? "\n" : "", name, shelf.one, entry.about,
                 entry.describe());
      found = true;
    }
  }
  if (found) return kDone;
  if (const auto file = text_of_file(name)) {
    fmt::print("{} ({})\n{}", name, file->kind, file->text);
    return kDone;
  }
  const std::string options = options_called(name);
  if (options.empty()) {
    // Or all of them, which are too many.
    const std::string nearest =
        name_or_path_suggestion(name, names, {.endings = endings_of_logs()});
    throw InputError({}, "there is nothing called " + in_quotes(name),
                     nearest.starts_with("did you mean")
                         ? nearest
                         : "'mapbed list' shows all names; a file is given by its path");
  }
  fmt::print("{} (option)\n{}", name, options);
  return kDone;
}

}  // namespace

Command list_command() {
  const auto kind = std::make_shared<std::string>();
  const auto about = std::make_shared<bool>(false);
  std::string kinds;
  for (const CatalogueShelf& shelf : catalogue()) {
    kinds += (kinds.empty() ? "" : ", ") + shelf.kind;
  }
  return {.name = "list",
          .help = "List what there is",
          .options = {{"KIND", kind.get(), "one of: " + kinds + "; all where left out"},
                      {"--about", about.get(),
                       "what sensors and robots promise, a line each: range, field of view, rate, "
                       "noise, size, limits, source"}},
          .run = [kind, about] {
            if (!kind->empty()) check_kind(*kind);
            return list(*kind, *about);
          }};
}

Command describe_command() {
  const auto name = std::make_shared<std::string>();
  return {.name = "describe",
          .help =
              "Show every option of a thing: default, unit, meaning, permitted values; what a "
              "file holds",
          .options = {{.name = "NAME",
                       .target = name.get(),
                       .help = "a name that 'mapbed list' shows, an option's name as in max_range, "
                               "or a file or folder that any command reads: a log or bag, a map, "
                               "a trajectory, relations, truth, results, the YAML file of a world, "
                               "robot, sensor, method, scenario or log",
                       .is_required = true}},
          .run = [name] { return describe(*name); }};
}

}  // namespace mapbed
