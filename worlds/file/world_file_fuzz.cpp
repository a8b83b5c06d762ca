// Whatever a world file says: a world with something in it, or an InputError.

#include "core/check.h"
#include "core/input_error.h"
#include "core/testing/fuzz_input.h"
#include "worlds/world.h"
#include "worlds/worlds.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mapbed;
  try {
    const World world = build_world(fuzz_file("world.yaml", data, size));
    CHECK(!world.entities.empty());
    CHECK(bounds_of(world).min().allFinite() && bounds_of(world).max().allFinite());
  } catch (const InputError&) {
    return 0;
  }
  return 0;
}
