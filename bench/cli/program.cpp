#include "bench/cli/program.h"

#include "bench/cli/command_line.h"
#include "bench/cli/commands.h"
#include "bench/process/version.h"

namespace mapbed {

int run_program(int argc, const char* const* argv) {
  const CommandLine line{
      .program = "mapbed",
      .help = "Makes maps and trajectories of what mobile robots measured, and judges them.",
      .footer =
          "'mapbed COMMAND --help' tells more about a command, 'mapbed list' what there is,\n"
          "'mapbed describe NAME' every option of it, 'mapbed describe FILE' what a file holds.\n"
          "Exit status: 0 done, 1 wrong input, 2 claims not held (--strict), 3 interrupted.",
      .version = version_text,
      .commands = {run_command(), map_command(), localize_command(), graph_command(),
                   evaluate_command(), render_command(), report_command(), list_command(),
                   describe_command(), simulate_command(), fetch_command()}};
  return run_command_line(line, argc, argv);
}

}  // namespace mapbed
