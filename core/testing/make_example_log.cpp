// Writes the log that ships with the program: a drive twice round the example place, with the noise
// of an ordinary robot. Always the same bytes of text.
//
//   make_example_log scenarios/logs/example.log.gz

#include <cstdio>

#include "core/input_error.h"
#include "core/log/dialects/carmen_log.h"
#include "core/testing/example_log.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: make_example_log FILE\n", stderr);
    return 1;
  }
  try {
    mapbed::write_carmen_log(argv[1], mapbed::example_log());
  } catch (const mapbed::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
