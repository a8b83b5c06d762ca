#include "core/file/text_file.h"

#include <climits>

#include <zlib.h>

#include "core/check.h"
#include "core/file/atomic_file.h"
#include "core/file/file_reader.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

// Some editors write it in front of UTF-8 text.
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

// As gzip: 15 is the longest window, 16 more ask for gzip's header, without name and time of the
// file.
std::string packed(std::string_view text) {
  z_stream stream{};
  const int begun =
      deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  CHECK(begun == Z_OK && text.size() < UINT_MAX);
  std::string result(deflateBound(&stream, text.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  const int ended = deflate(&stream, Z_FINISH);
  CHECK(ended == Z_STREAM_END);
  result.resize(stream.total_out);
  deflateEnd(&stream);
  return result;
}

}  // namespace

std::string read_text_file(const std::string& path, std::size_t max_bytes) {
  FileReader file(path);
  std::string content;
  for (std::string_view piece = file.next(); !piece.empty(); piece = file.next()) {
    content += piece;
    if (content.size() > max_bytes) {
      throw InputError({path}, "holds more than " + std::to_string(max_bytes >> 20) + " MB");
    }
  }
  if (content.starts_with(kByteOrderMark)) content.erase(0, kByteOrderMark.size());
  return content;
}

void write_text_file(const std::string& path, std::string_view text) {
  write_file(path, path.ends_with(".gz") ? packed(text) : std::string(text));
}

}  // namespace mapbed
