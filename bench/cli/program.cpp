#include "bench/cli/program.h"

#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "bench/cli/commands.h"
#include "bench/process/version.h"
#include "core/config/suggestion.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

std::vector<std::string> command_names(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

// What was wrong with the command line, in one line with a remedy.
InputError explained(const CLI::ParseError& error, const CLI::App& program) {
  const std::vector<CLI::App*> chosen = program.get_subcommands();
  const std::vector<std::string> unread = program.remaining(true);
  if (chosen.empty() && !unread.empty() && !unread.front().starts_with('-')) {
    const std::string& word = unread.front();
    return InputError({}, fmt::format("unknown command '{}'", word),
                      suggestion(word, command_names(program)));
  }
  const CLI::App& command = chosen.empty() ? program : *chosen.front();
  for (const std::string& argument : unread) {
    if (!argument.starts_with('-')) continue;
    const std::string name = argument.substr(0, argument.find('='));
    return InputError({}, fmt::format("unknown option '{}'", name),
                      suggestion(name, option_names(command)));
  }
  const std::string help = (chosen.empty() ? "" : chosen.front()->get_name() + " ") + "--help";
  const std::string remedy = "see 'mapbed " + help + "'";
  if (!unread.empty()) {
    return InputError({}, fmt::format("one argument too many: '{}'", unread.front()), remedy);
  }
  return InputError({}, error.what(), remedy);
}

}  // namespace

int run_program(int argc, const char* const* argv) {
  CLI::App program("Makes maps and trajectories of what mobile robots measured, and judges them.",
                   "mapbed");
  program.set_version_flag(
      "--version", [] { return version_text(); },
      "Print the revision and the versions of the libraries");
  program.require_subcommand(0, 1);
  program.footer(
      "'mapbed COMMAND --help' tells more about a command.\n"
      "Exit status: 0 done, 1 wrong input, 2 claims not held, 3 interrupted.");
  Action action;
  add_run_command(program, action);
  add_map_command(program, action);
  add_evaluate_command(program, action);
  add_render_command(program, action);
  add_report_command(program, action);
  add_list_command(program, action);
  add_describe_command(program, action);
  add_simulate_command(program, action);

  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& success) {  // help or version was asked for, and is printed
    return program.exit(success);
  } catch (const CLI::ParseError& error) {
    throw explained(error, program);
  }
  if (!action) {
    fmt::print("{}", program.help());
    return kDone;
  }
  return action();
}

}  // namespace mapbed
