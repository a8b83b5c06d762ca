#include "core/file/gzip_writer.h"

#include <algorithm>
#include <array>

#include <zlib.h>

#include "core/check.h"
#include "core/file/atomic_file.h"

namespace mapbed {

struct GzipWriter::State {
  explicit State(const std::string& path) : file(path) {
    // 15 is the longest window, 16 more ask for gzip's header, without name and time of the file.
    const int code =
        deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
    CHECK(code == Z_OK);
  }
  ~State() { deflateEnd(&stream); }

  void pack(std::string_view bytes, int flush) {
    std::array<char, 1U << 16> packed;
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    do {
      stream.next_out = reinterpret_cast<Bytef*>(packed.data());
      stream.avail_out = static_cast<uInt>(packed.size());
      const int code = deflate(&stream, flush);
      CHECK(code != Z_STREAM_ERROR);
      file.stream().write(packed.data(),
                          static_cast<std::streamsize>(packed.size() - stream.avail_out));
    } while (stream.avail_out == 0);
  }

  AtomicFile file;
  z_stream stream{};
};

GzipWriter::GzipWriter(const std::string& path) : state_(std::make_unique<State>(path)) {}
GzipWriter::~GzipWriter() = default;

void GzipWriter::write(std::string_view bytes) {
  constexpr std::size_t kMost = std::size_t{1} << 30;  // zlib counts in 32 bits
  for (; !bytes.empty(); bytes.remove_prefix(std::min(kMost, bytes.size()))) {
    state_->pack(bytes.substr(0, kMost), Z_NO_FLUSH);
  }
}

void GzipWriter::commit() {
  state_->pack({}, Z_FINISH);
  state_->file.commit();
}

std::string gzipped(std::string_view bytes, GzipForm form) {
  CHECK(bytes.size() < std::size_t{1} << 31);  // zlib counts in 32 bits
  z_stream stream{};
  const int memory = form == GzipForm::gzip ? 9 : 8;
  const int code =
      deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, 15 + 16, memory, Z_DEFAULT_STRATEGY);
  CHECK(code == Z_OK);
  gz_header header{};
  header.os = form == GzipForm::python ? 255 : 3;  // unknown; Unix
  deflateSetHeader(&stream, &header);
  std::string packed(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  const int ended = deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  CHECK(ended == Z_STREAM_END);
  return packed;
}

}  // namespace mapbed
