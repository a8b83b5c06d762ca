#include "core/file/text_blocks.h"

#include <cerrno>
#include <cstring>
#include <memory>

#include <fmt/core.h>
#include <sys/stat.h>
#include <zlib.h>

#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr std::size_t kBlock = 1 << 20;          // [bytes]
constexpr std::size_t kLongestLine = 16u << 20;  // [bytes]

struct Closer {
  void operator()(gzFile file) const { gzclose(file); }
};
using File = std::unique_ptr<gzFile_s, Closer>;

// zlib reads plain files as they are.
File opened(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0)
    throw InputError({path}, std::strerror(errno), "check the file's name");
  if (S_ISDIR(status.st_mode)) throw InputError({path}, "is a folder", "name a file in it");
  errno = 0;
  File file(gzopen(path.c_str(), "rb"));
  if (!file) throw InputError({path}, errno != 0 ? std::strerror(errno) : "cannot be opened");
  gzbuffer(file.get(), 1 << 18);
  return file;
}

[[noreturn]] void unpacking_failed(const std::string& path, gzFile file) {
  int code = Z_OK;
  const std::string text = gzerror(file, &code);
  if (code == Z_BUF_ERROR)
    throw InputError({path}, "the gzip file is cut short", "fetch or copy it again");
  throw InputError({path}, "cannot be unpacked (" + text + ")", "fetch or copy it again");
}

}  // namespace

void for_each_text_block(const std::string& path, double max_text,
                         const std::function<void(std::string_view)>& take) {
  const File file = opened(path);
  std::string buffer;
  std::size_t filled = 0;  // the beginning of a line whose end is not here yet
  double total = 0.0;
  for (;;) {
    if (buffer.size() < filled + kBlock) buffer.resize(filled + kBlock);
    const int got = gzread(file.get(), buffer.data() + filled, kBlock);
    int code = Z_OK;
    gzerror(file.get(), &code);
    if (got < 0 || code == Z_BUF_ERROR) unpacking_failed(path, file.get());
    total += got;
    if (total > max_text)
      throw InputError({path}, fmt::format("unpacks to more than {} MB", max_text / 1e6),
                       "set max_text if the file is to be trusted");
    const std::string_view text(buffer.data(), filled + static_cast<std::size_t>(got));
    if (got == 0) {
      if (!text.empty()) take(text);
      return;
    }
    const std::size_t end = text.rfind('\n');
    if (end == std::string_view::npos) {
      filled = text.size();
      if (filled > kLongestLine)
        throw InputError({path}, "has a line of more than 16 MiB", "this is no text log");
      continue;
    }
    take(text.substr(0, end + 1));
    filled = text.size() - (end + 1);
    std::memmove(buffer.data(), buffer.data() + end + 1, filled);
  }
}

}  // namespace mapbed
