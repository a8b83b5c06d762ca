#pragma once

namespace mapbed {

// Reads the command line and does what it says. Throws InputError.
int run_program(int argc, const char* const* argv);

}  // namespace mapbed
