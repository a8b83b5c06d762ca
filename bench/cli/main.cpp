#include <cstdio>
#include <exception>
#include <system_error>

#include <fmt/format.h>
#include <malloc.h>

#include "bench/cli/commands.h"
#include "bench/cli/program.h"
#include "bench/process/standard_streams.h"
#include "core/failure_text.h"

namespace {

int run_and_flush(int argc, char** argv) {
  try {
    const int status = mapbed::run_program(argc, argv);
    mapbed::check_standard_output();
    return status;
  } catch (const std::system_error&) {
    mapbed::check_standard_output();  // where printing has failed before the end, this says so
    throw;
  }
}

}  // namespace

int main(int argc, char** argv) {
  // Tiles of maps and scratch fields go back to the system when freed. Left to itself, glibc raises
  // this limit with the first large block and keeps a quarter of the peak in holes between them.
  mallopt(M_MMAP_THRESHOLD, 32 * 1024);
  mapbed::reserve_standard_streams();
  try {
    return run_and_flush(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "mapbed: {}\n", mapbed::failure_text(error));
  }
  return mapbed::kWrongInput;
}
