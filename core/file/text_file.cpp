#include "core/file/text_file.h"

#include "core/file/atomic_file.h"
#include "core/file/file_reader.h"
#include "core/file/gzip_writer.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

// Some editors write it in front of UTF-8 text.
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

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
  write_file(path, path.ends_with(".gz") ? gzipped(text, GzipForm::plain) : std::string(text));
}

}  // namespace mapbed
