#include "bench/cli/command_line.h"

#include <type_traits>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "core/config/suggestion.h"
#include "core/file/tokens.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr double kLargestNumber = 1e6;  // of seconds, metres, frames or people

bool has_name(const CommandOption& option) {
  return option.name.starts_with('-');
}

// CLI11 reads numbers as the locale has them, and infinity as one.
CLI::Option* add_number(CLI::App& command, const CommandOption& option, double& target) {
  const auto read = [&target, name = option.name](const std::string& text) {
    if (!parse_number(text, target)) throw CLI::ConversionError(text, name);
  };
  CLI::Option* added = command.add_option_function<std::string>(option.name, read, option.help);
  added->type_name("FLOAT");
  if (option.shows_default) added->default_str(fmt::format("{}", target));
  return added;
}

CLI::Option* add_to(CLI::App& command, const CommandOption& option) {
  return std::visit(
      [&](auto* target) -> CLI::Option* {
        using Target = std::remove_pointer_t<decltype(target)>;
        if constexpr (std::is_same_v<Target, bool>) {
          return command.add_flag(option.name, *target, option.help);
        } else if constexpr (std::is_same_v<Target, double>) {
          return add_number(command, option, *target);
        } else {
          CLI::Option* added = command.add_option(option.name, *target, option.help);
          if constexpr (std::is_same_v<Target, std::vector<std::string>>) {
            if (has_name(option)) added->allow_extra_args(false);  // one behind each name
          }
          return added;
        }
      },
      option.target);
}

struct AddCheck {
  CLI::Option& option;

  void operator()(std::monostate) const {}
  void operator()(const IntRange& range) const {
    option.check(CLI::Range(range.least, range.most));
  }
  void operator()(Sign sign) const {
    const bool is_positive = sign == Sign::positive;
    const auto objection = [is_positive](const std::string& text) {
      double number = 0.0;
      const bool fits = parse_number(text, number) && number <= kLargestNumber &&
                        (is_positive ? number > 0.0 : number >= 0.0);
      if (fits) return std::string();
      return fmt::format("{} is not a number {} and at most {:g}", in_quotes(text),
                         is_positive ? "above 0" : "from 0 on", kLargestNumber);
    };
    option.check(objection, is_positive ? "POSITIVE" : "NONNEGATIVE");
  }
  void operator()(const std::vector<std::string>& words) const {
    option.check(CLI::IsMember(words));
  }
};

void add_to(CLI::App& program, const Command& command) {
  CLI::App& added = *program.add_subcommand(command.name, command.help);
  for (const CommandOption& option : command.options) {
    CLI::Option& made = *add_to(added, option);
    if (option.is_required) made.required();
    const bool is_number = std::holds_alternative<double*>(option.target);
    if (option.shows_default && !is_number) made.capture_default_str();
    if (!option.needs.empty()) made.needs(added.get_option(option.needs));
    if (!option.group.empty()) made.group(option.group);
    std::visit(AddCheck{made}, option.check);
  }
}

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
  const std::string remedy = "see '" + program.get_name() + " " + help + "'";
  if (!unread.empty()) {
    return InputError({}, fmt::format("one argument too many: '{}'", unread.front()), remedy);
  }
  return InputError({}, error.what(), remedy);
}

}  // namespace

int run_command_line(const CommandLine& line, int argc, const char* const* argv) {
  CLI::App program(line.help, line.program);
  program.set_version_flag("--version", line.version,
                           "Print the revision and the versions of the libraries");
  program.require_subcommand(0, 1);
  program.footer(line.footer);
  for (const Command& command : line.commands) add_to(program, command);
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& success) {  // help or version was asked for, and is printed
    return program.exit(success);
  } catch (const CLI::ParseError& error) {
    throw explained(error, program);
  }
  for (const Command& command : line.commands) {
    if (program.got_subcommand(command.name)) return command.run();
  }
  fmt::print("{}", program.help());
  return 0;
}

}  // namespace mapbed
