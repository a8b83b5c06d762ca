// Whatever a robot's or a sensor's file says: a robot whose options are within their bounds, or an
// InputError.

#include "core/check.h"
#include "core/config/settings.h"
#include "core/input_error.h"
#include "core/testing/fuzz_input.h"
#include "robots/robot.h"
#include "robots/sensor_model.h"

namespace {

using namespace mapbed;

template <class Read>
void read_and_write(Read read) {
  try {
    auto model = read();
    (void)to_yaml(options_of(model));
  } catch (const InputError&) {
    return;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string path = fuzz_file("fuzz.yaml", data, size);
  read_and_write([&] { return load_robot(path); });
  read_and_write([&] { return load_laser(path); });
  return 0;
}
