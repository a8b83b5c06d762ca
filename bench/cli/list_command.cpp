#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "bench/cli/catalogue.h"
#include "bench/cli/command_line.h"
#include "bench/cli/commands.h"
#include "bench/methods/program_method.h"
#include "core/config/suggestion.h"
#include "core/input_error.h"
#include "core/log/log_file.h"

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

int describe(const std::string& name) {
  std::vector<std::string> names;
  for (const CatalogueShelf& shelf : catalogue()) {
    for (const CatalogueEntry& entry : shelf.entries()) {
      if (entry.name == name) {
        fmt::print("{} ({}): {}\n{}", entry.name, shelf.one, entry.about, entry.describe());
        return kDone;
      }
      names.push_back(entry.name);
    }
  }
  if (const auto bag = bag_contents(name)) {
    // First of all, so that it is there also where it is not clear which topics are meant.
    fmt::print("{} (log)\n{}", name, text_of_bag(*bag));
    try {
      const std::string text = text_of_log(name);
      fmt::print("{}", text.substr(text.find('\n') + 1));  // the format is told
    } catch (const InputError& error) {
      fmt::print("remark: {}\n", error.what());
    }
    return kDone;
  }
  if (is_program_file(name)) {
    fmt::print("{} (method)\n{}", name, load_program_method(name).description());
    return kDone;
  }
  if (std::filesystem::is_regular_file(name)) {
    fmt::print("{} (log)\n{}", name, text_of_log(name));
    return kDone;
  }
  throw InputError({}, "there is nothing called '" + name + "'", suggestion(name, names));
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
          .help = "Show every option of a thing: default, unit, meaning; what a log holds",
          .options = {{.name = "NAME",
                       .target = name.get(),
                       .help = "a name that 'mapbed list' shows, or the file of a log or bag",
                       .is_required = true}},
          .run = [name] { return describe(*name); }};
}

}  // namespace mapbed
