#include <cstdio>
#include <exception>

#include <fmt/format.h>

#include "bench/cli/commands.h"
#include "bench/cli/program.h"
#include "core/input_error.h"

int main(int argc, char** argv) {
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
