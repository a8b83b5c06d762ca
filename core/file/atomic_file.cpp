#include "core/file/atomic_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <streambuf>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/check.h"
#include "core/file/tokens.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

constexpr const char* kIsItThere = "is there such a folder, and may you write to it?";

[[noreturn]] void refuse_path(const std::string& path, int reason, const std::string& remedy = "") {
  throw InputError(SourceLocation{path}, std::string("cannot be written: ") + std::strerror(reason),
                   remedy);
}

// Of this program, where the name stands for one that is open, as /dev/stdout does; else -1.
int descriptor_named(const fs::path& path) {
  std::error_code error;
  const fs::path folder = fs::canonical(path.parent_path(), error);
  if (error || folder != "/proc/" + std::to_string(::getpid()) + "/fd") return -1;
  int descriptor = -1;
  return parse_number(path.filename().string(), descriptor) ? descriptor : -1;
}

// What a path stands for behind all symbolic links; the last of them may point to nothing yet.
struct Target {
  fs::path path;
  int descriptor = -1;  // that is open already
  fs::file_type type = fs::file_type::not_found;

  bool is_special() const {
    return descriptor >= 0 || (type != fs::file_type::not_found && type != fs::file_type::regular);
  }
};

Target target_of(const std::string& path) {
  constexpr int kMostLinks = 40;
  Target target{.path = path};
  std::error_code error;
  for (int links = 0;; ++links) {
    target.descriptor = descriptor_named(target.path);
    if (target.descriptor >= 0 || !fs::is_symlink(target.path, error)) break;
    if (links == kMostLinks) refuse_path(path, ELOOP);
    target.path = target.path.parent_path() / fs::read_symlink(target.path, error);
  }
  target.type = fs::status(target.path, error).type();
  if (target.type == fs::file_type::none) refuse_path(path, error.value(), kIsItThere);
  if (target.type == fs::file_type::directory) {
    throw InputError(SourceLocation{path}, "is a folder", "name a file in it");
  }
  if (path.empty()) throw InputError("a file to write has no name");
  return target;
}

int open_special(const Target& target) {
  if (target.descriptor >= 0) return ::fcntl(target.descriptor, F_DUPFD_CLOEXEC, 0);
  return ::open(target.path.c_str(), O_WRONLY | O_CLOEXEC);
}

// Whether the name is still that of the open file, and not of another or of none.
bool is_still_there(int file, const std::string& path) {
  struct stat opened {};
  struct stat named {};
  return ::fstat(file, &opened) == 0 && ::stat(path.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

// Some file systems know no such request, which is no failure of the disk.
bool is_failure(int status) {
  return status != 0 && errno != EINVAL && errno != ENOTSUP && errno != EROFS;
}

}  // namespace

// Bytes on their way into an open file. The first reason for which not all got there is kept.
class AtomicFile::Buffer : public std::streambuf {
 public:
  explicit Buffer(int file) : file_(file) { setp(bytes_.data(), bytes_.data() + bytes_.size()); }
  ~Buffer() override { ::close(file_); }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;

  int file() const { return file_; }
  int reason() const { return reason_; }

 protected:
  int sync() override {
    const auto size = static_cast<std::size_t>(pptr() - pbase());
    setp(bytes_.data(), bytes_.data() + bytes_.size());
    return put(bytes_.data(), size) ? 0 : -1;
  }
  int_type overflow(int_type c) override {
    if (sync() != 0) return traits_type::eof();
    if (!traits_type::eq_int_type(c, traits_type::eof())) sputc(traits_type::to_char_type(c));
    return traits_type::not_eof(c);
  }
  std::streamsize xsputn(const char* bytes, std::streamsize size) override {
    if (size < epptr() - pptr()) return std::streambuf::xsputn(bytes, size);
    return sync() == 0 && put(bytes, static_cast<std::size_t>(size)) ? size : 0;
  }

 private:
  bool put(const char* bytes, std::size_t size) {
    while (size > 0 && reason_ == 0) {
      const ssize_t written = ::write(file_, bytes, size);
      if (written < 0 && errno != EINTR) reason_ = errno;
      if (written <= 0) continue;
      bytes += written;
      size -= static_cast<std::size_t>(written);
    }
    return reason_ == 0;
  }

  int file_;
  int reason_ = 0;
  std::array<char, 1U << 16> bytes_;
};

AtomicFile::AtomicFile(const std::string& path, Durability durability)
    : path_(path), durability_(durability) {
  const Target target = target_of(path);
  if (target.is_special()) {
    const int file = open_special(target);
    if (file < 0) refuse(errno);
    buffer_ = std::make_unique<Buffer>(file);
  } else {
    target_ = target.path.string();
    open_unfinished();
  }
  stream_.rdbuf(buffer_.get());
}

// Under a name that no other process or thread holds. Whoever writes holds the file's lock, which
// ends with the program: what is not locked was left by one that is dead.
void AtomicFile::open_unfinished() {
  constexpr std::size_t kLongest = 200;  // [bytes] of 255 that a name may have
  const fs::path target(target_);
  const std::string name = "." + target.filename().string().substr(0, kLongest) + ".unfinished";
  for (int attempt = 0;;) {
    const std::string suffix = attempt == 0 ? "" : "-" + std::to_string(attempt);
    const std::string path = (target.parent_path() / (name + suffix)).string();
    const int file = ::open(path.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (file < 0) refuse(errno);
    const bool is_ours = ::flock(file, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
    if (is_ours && is_still_there(file, path)) {
      unfinished_ = path;
      buffer_ = std::make_unique<Buffer>(file);
      if (::ftruncate(file, 0) != 0) refuse(errno);
      return;
    }
    ::close(file);
    if (!is_ours) ++attempt;
  }
}

AtomicFile::~AtomicFile() {
  if (!unfinished_.empty()) std::remove(unfinished_.c_str());
}

void AtomicFile::refuse(int reason) const {
  if (reason == ENOSPC || reason == EDQUOT || reason == EFBIG) {
    throw InputError(SourceLocation{path_}, "cannot be written completely", "is the disk full?");
  }
  refuse_path(path_, reason, kIsItThere);
}

void AtomicFile::commit() {
  CHECK(buffer_ != nullptr);
  stream_.flush();
  if (buffer_->reason() != 0) refuse(buffer_->reason());
  CHECK(stream_.good());
  if (!unfinished_.empty()) {
    const bool is_synced = durability_ == Durability::synced;
    if (is_synced && is_failure(::fsync(buffer_->file()))) refuse(errno);
    if (std::rename(unfinished_.c_str(), target_.c_str()) != 0) refuse(errno);
    unfinished_.clear();
    if (is_synced) sync_folder(fs::path(target_).parent_path().string());
  }
  stream_.rdbuf(nullptr);
  buffer_.reset();
}

void write_file(const std::string& path, std::string_view content, Durability durability) {
  AtomicFile file(path, durability);
  file.stream().write(content.data(), static_cast<std::streamsize>(content.size()));
  file.commit();
}

void check_writable(const std::string& path) {
  const Target target = target_of(path);
  if (!target.is_special()) {
    const AtomicFile file(path);
  } else if (target.descriptor < 0 && ::access(target.path.c_str(), W_OK) != 0) {
    refuse_path(path, errno);
  }
}

bool is_special_file(const std::string& path) {
  return target_of(path).is_special();
}

void sync_folder(const std::string& folder) {
  sync_file(folder.empty() ? "." : folder);
}

void sync_file(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0 && errno == EACCES) return;  // a folder may be written to and not be read
  if (file < 0) refuse_path(path, errno);
  const bool failed = is_failure(::fsync(file));
  const int reason = errno;
  ::close(file);
  if (failed) refuse_path(path, reason);
}

}  // namespace mapbed
