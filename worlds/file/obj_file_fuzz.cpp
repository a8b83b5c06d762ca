// Whatever the bytes: triangles over vertices that are there, or an InputError.

#include "core/check.h"
#include "core/geometry/triangle_mesh.h"
#include "core/input_error.h"
#include "core/testing/fuzz_input.h"
#include "worlds/file/obj_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mapbed;
  try {
    const TriangleMesh mesh = parse_obj("fuzz", fuzz_text(data, size));
    CHECK(!mesh.triangles.empty());
    for (const auto& triangle : mesh.triangles) {
      for (const std::uint32_t corner : triangle) CHECK(corner < mesh.vertices.size());
    }
  } catch (const InputError&) {
    return 0;
  }
  return 0;
}
