#include "core/file/file_reader.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include <zlib.h>

#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr std::size_t kPiece = 1 << 18;          // [bytes]
constexpr std::size_t kLongestLine = 16u << 20;  // [bytes]

gzFile as_gz(void* file) {
  return static_cast<gzFile>(file);
}

}  // namespace

void check_is_file(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw InputError({path}, "no such file");
  if (std::filesystem::is_directory(status)) throw InputError({path}, "is a folder, not a file");
}

void FileReader::Close::operator()(void* file) const {
  gzclose_r(as_gz(file));
}

FileReader::FileReader(const std::string& path) : path_(path) {
  check_is_file(path);
  errno = 0;
  file_.reset(gzopen(path.c_str(), "rb"));  // hands on what is not gzip as it is
  if (!file_) {
    const std::string reason = errno != 0 ? std::strerror(errno) : "no memory";
    throw InputError({path}, "cannot be opened: " + reason, "check its permissions");
  }
  gzbuffer(as_gz(file_.get()), 1U << 18);
  piece_.resize(kPiece);
}

std::string_view FileReader::next() {
  const int count = gzread(as_gz(file_.get()), piece_.data(), static_cast<unsigned>(kPiece));
  int code = Z_OK;
  const std::string text = gzerror(as_gz(file_.get()), &code);
  if (code == Z_ERRNO) throw InputError({path_}, "cannot be read: " + text);
  if (code == Z_BUF_ERROR) {
    throw InputError({path_}, "the gzip data are cut short", "fetch or copy the file again");
  }
  if (count < 0) {
    throw InputError({path_}, "the gzip data are damaged (" + text + ")",
                     "fetch or copy the file again");
  }
  return {piece_.data(), static_cast<std::size_t>(count)};
}

void LineSplitter::keep(std::string_view beginning) {
  begun_ += beginning;
  if (begun_.size() > kLongestLine) {
    throw InputError({name_}, "has a line of more than 16 MiB", "is this a file of lines?");
  }
}

}  // namespace mapbed
