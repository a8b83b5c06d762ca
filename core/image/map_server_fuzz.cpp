// Whatever a map_server file says of a small picture: probabilities or unknown cells, or an
// InputError.

#include "core/check.h"
#include "core/image/map_server.h"
#include "core/image/samples.h"
#include "core/input_error.h"
#include "core/testing/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mapbed;
  try {
    const MapServerFile file = read_map_server_file(fuzz_file("map.yaml", data, size));
    const Samples picture{
        .width = 3, .height = 1, .channels = 2, .values = {0, 255, 100, 0, 255, 255}};
    const Image<float> occupancy = occupancy_of(picture, file);
    for (const float p : occupancy.pixels()) {
      CHECK(p == MapServerMap::kUnknown || (p >= 0.0F && p <= 1.0F));
    }
  } catch (const InputError&) {
    return 0;
  }
  return 0;
}
