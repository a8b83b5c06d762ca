#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace mapbed {

// What the command line asks for, done after all of it has been read; gives the exit status.
using Action = std::function<int()>;

// The exit status of the program.
enum ExitStatus : int {
  kDone = 0,
  kWrongInput = 1,  // one line on stderr
  kClaimsNotHeld = 2,
  kInterrupted = 3,
};

// Each adds its command to the program; where that is chosen, `action` becomes what it does.
void add_evaluate_command(CLI::App& program, Action& action);
void add_list_command(CLI::App& program, Action& action);
void add_describe_command(CLI::App& program, Action& action);
void add_map_command(CLI::App& program, Action& action);
void add_render_command(CLI::App& program, Action& action);
void add_report_command(CLI::App& program, Action& action);
void add_run_command(CLI::App& program, Action& action);
void add_simulate_command(CLI::App& program, Action& action);

}  // namespace mapbed
