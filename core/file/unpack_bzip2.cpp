#include <algorithm>
#include <limits>

#include <bzlib.h>

#include "core/file/unpack_steps.h"

namespace mapbed {
namespace {

unsigned bounded(std::size_t bytes) {
  return static_cast<unsigned>(
      std::min<std::size_t>(bytes, std::numeric_limits<unsigned>::max() / 2));
}

class Stream {
 public:
  explicit Stream(std::string_view packed) : packed_(packed) {
    is_open_ = BZ2_bzDecompressInit(&stream_, 0, 0) == BZ_OK;
  }
  ~Stream() {
    if (is_open_) BZ2_bzDecompressEnd(&stream_);
  }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  UnpackStep step(char* output, std::size_t room) {
    if (!is_open_) return {0, UnpackState::damaged};
    const unsigned given = bounded(packed_.size());
    const unsigned wanted = bounded(room);
    stream_.next_in = const_cast<char*>(packed_.data());  // it only reads them
    stream_.avail_in = given;
    stream_.next_out = output;
    stream_.avail_out = wanted;
    const int code = BZ2_bzDecompress(&stream_);
    packed_.remove_prefix(given - stream_.avail_in);
    const UnpackState state = code == BZ_STREAM_END ? UnpackState::done
                              : code == BZ_OK       ? UnpackState::more
                                                    : UnpackState::damaged;
    return {wanted - stream_.avail_out, state};
  }

 private:
  std::string_view packed_;
  bz_stream stream_ = {};
  bool is_open_ = false;
};

}  // namespace

Unpacked unpack_bzip2(std::string_view packed, std::size_t max_bytes) {
  Stream stream(packed);
  return unpack_in_steps(max_bytes,
                         [&](char* output, std::size_t room) { return stream.step(output, room); });
}

}  // namespace mapbed
