#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace mapbed {

// Where what stands behind an option goes, and so what may stand there. A bool becomes true where
// the option is named; a vector takes one text each time that it is, or all words that are left.
using OptionTarget =
    std::variant<bool*, int*, std::uint64_t*, double*, std::string*, std::optional<int>*,
                 std::optional<std::uint64_t>*, std::vector<std::string>*>;

struct IntRange {
  int least = 0;
  int most = 0;
};
enum class Sign { not_negative, positive };
using OptionCheck = std::variant<std::monostate, IntRange, Sign, std::vector<std::string>>;

// An option of a command, or a word without a name.
struct CommandOption {
  std::string name;  // "--seed", "-j,--threads"; "LOG": a word by its place
  OptionTarget target;
  std::string help;
  OptionCheck check = {};  // what may stand there: a range, a sign, one of these words
  bool is_required = false;
  bool shows_default = false;  // in the help: what the target holds before anything is read
  std::string needs = {};      // name of an option before it, without which it means nothing
  std::string group = {};      // heading in the help; that of all others if empty
};

struct Command {
  std::string name;
  std::string help;
  std::vector<CommandOption> options;
  std::function<int()> run;  // called after all is read; gives the exit status
};

struct CommandLine {
  std::string program;
  std::string help;
  std::string footer;                    // of every help text
  std::function<std::string()> version;  // what --version prints
  std::vector<Command> commands;         // in the order of the help
};

// Reads the arguments into the targets of the command that they name and runs it, or prints the
// help or version that they ask for. Gives the exit status; throws InputError, one line with a
// remedy, where they are not understood.
int run_command_line(const CommandLine& line, int argc, const char* const* argv);

}  // namespace mapbed
