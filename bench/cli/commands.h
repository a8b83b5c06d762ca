#pragma once

namespace mapbed {

struct Command;

// The exit status of the program.
enum ExitStatus : int {
  kDone = 0,
  kWrongInput = 1,  // one line on stderr
  kClaimsNotHeld = 2,
  kInterrupted = 3,
};

// Each command of the program, with its options and what it does.
Command evaluate_command();
Command fetch_command();
Command graph_command();
Command list_command();
Command describe_command();
Command localize_command();
Command map_command();
Command render_command();
Command report_command();
Command run_command();
Command simulate_command();

}  // namespace mapbed
