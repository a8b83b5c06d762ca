#pragma once

namespace mapbed {

// Standard input, output and error that were closed by the caller are opened, so that no file gets
// their numbers and none of the program's words. Reading or writing them fails as before.
void reserve_standard_streams();

// Throws InputError where not all that was written to standard output got there (disk full).
void check_standard_output();

}  // namespace mapbed
