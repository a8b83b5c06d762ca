#include <memory>

#include <lz4frame.h>

#include "core/file/unpack_steps.h"

namespace mapbed {
namespace {

struct Free {
  void operator()(LZ4F_dctx* context) const { LZ4F_freeDecompressionContext(context); }
};

}  // namespace

Unpacked unpack_lz4(std::string_view packed, std::size_t max_bytes) {
  LZ4F_dctx* made = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&made, LZ4F_VERSION)) != 0) return {};
  const std::unique_ptr<LZ4F_dctx, Free> context(made);
  return unpack_in_steps(max_bytes, [&](char* output, std::size_t room) -> UnpackStep {
    std::size_t written = room;
    std::size_t taken = packed.size();
    const std::size_t code =
        LZ4F_decompress(context.get(), output, &written, packed.data(), &taken, nullptr);
    if (LZ4F_isError(code) != 0) return {0, UnpackState::damaged};
    packed.remove_prefix(taken);
    return {written, code == 0 ? UnpackState::done : UnpackState::more};
  });
}

}  // namespace mapbed
