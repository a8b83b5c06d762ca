#include <memory>

#include <zstd.h>

#include "core/file/unpack_steps.h"

namespace mapbed {
namespace {

struct Free {
  void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
};

}  // namespace

Unpacked unpack_zstd(std::string_view packed, std::size_t max_bytes) {
  const std::unique_ptr<ZSTD_DCtx, Free> context(ZSTD_createDCtx());
  if (!context) return {};
  ZSTD_inBuffer input{packed.data(), packed.size(), 0};
  return unpack_in_steps(max_bytes, [&](char* output, std::size_t room) -> UnpackStep {
    ZSTD_outBuffer made{output, room, 0};
    std::size_t code = 1;
    do {  // it may stop anywhere; an empty frame gives nothing and is not the end
      code = ZSTD_decompressStream(context.get(), &made, &input);
      if (ZSTD_isError(code) != 0) return {made.pos, UnpackState::damaged};
    } while (input.pos < input.size && made.pos < made.size);
    const bool is_done = code == 0 && input.pos == input.size;
    return {made.pos, is_done ? UnpackState::done : UnpackState::more};
  });
}

}  // namespace mapbed
