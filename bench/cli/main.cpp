#include <cstdio>
#include <exception>

#include <fmt/format.h>
#include <malloc.h>

#include "bench/cli/commands.h"
#include "bench/cli/program.h"
#include "core/input_error.h"

int main(int argc, char** argv) {
  // Tiles of maps and scratch fields go back to the system when freed. Left to itself, glibc raises
  // this limit with the first large block and keeps a quarter of the peak in holes between them.
  mallopt(M_MMAP_THRESHOLD, 32 * 1024);
  try {
    return mapbed::run_program(argc, argv);
  } catch (const mapbed::InputError& error) {
    fmt::print(stderr, "mapbed: {}\n", error.what());
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "mapbed: out of memory\n");
  } catch (const std::exception& error) {
    fmt::print(stderr, "mapbed: {}\n", error.what());
  }
  return mapbed::kWrongInput;
}
