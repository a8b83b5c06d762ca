#include "core/file/text_file.h"

#include <algorithm>
#include <charconv>
#include <climits>
#include <cmath>
#include <filesystem>
#include <memory>
#include <system_error>

#include <zlib.h>

#include "core/check.h"
#include "core/file/atomic_file.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr std::string_view kBlanks = " \t";

struct CloseGz {
  void operator()(gzFile file) const { gzclose_r(file); }
};
using GzReader = std::unique_ptr<std::remove_pointer_t<gzFile>, CloseGz>;

void refuse_what_is_no_file(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw InputError({path}, "no such file");
  if (std::filesystem::is_directory(status)) throw InputError({path}, "is a folder, not a file");
}

// As gzip: 15 is the longest window, 16 more ask for gzip's header, without name and time of the
// file.
std::string packed(std::string_view text) {
  z_stream stream{};
  CHECK(deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) ==
        Z_OK);
  CHECK(text.size() < UINT_MAX);
  std::string result(deflateBound(&stream, text.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  CHECK(deflate(&stream, Z_FINISH) == Z_STREAM_END);
  result.resize(stream.total_out);
  deflateEnd(&stream);
  return result;
}

}  // namespace

std::string read_text_file(const std::string& path, std::size_t max_bytes) {
  refuse_what_is_no_file(path);
  const GzReader file(gzopen(path.c_str(), "rb"));  // hands on what is not gzip as it is
  if (!file) throw InputError({path}, "cannot be opened", "check its permissions");
  gzbuffer(file.get(), 1U << 17);

  std::string content;
  constexpr std::size_t chunk = 1U << 20;
  for (;;) {
    const std::size_t before = content.size();
    content.resize(before + chunk);
    const int count = gzread(file.get(), content.data() + before, static_cast<unsigned>(chunk));
    int code = Z_OK;
    gzerror(file.get(), &code);
    if (code == Z_ERRNO) throw InputError({path}, "cannot be read", "check its permissions");
    if (count < 0 || code == Z_BUF_ERROR) {
      throw InputError({path}, "the gzip data are damaged or cut short", "fetch the file again");
    }
    content.resize(before + static_cast<std::size_t>(count));
    if (content.size() > max_bytes) {
      throw InputError({path}, "holds more than " + std::to_string(max_bytes >> 20) + " MB");
    }
    if (count == 0) return content;
  }
}

void write_text_file(const std::string& path, std::string_view text) {
  write_file(path, path.ends_with(".gz") ? packed(text) : std::string(text));
}

std::string_view next_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::string_view next_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
  const std::size_t end = std::min(line.find_first_of(kBlanks), line.size());
  const std::string_view word = line.substr(0, end);
  line.remove_prefix(end);
  return word;
}

bool parse_number(std::string_view word, double& number) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc{} && end == word.data() + word.size() && std::isfinite(number);
}

}  // namespace mapbed
