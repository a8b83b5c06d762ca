#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace mapbed {

// Throws InputError where there is no such file or it is a folder.
void check_is_file(const std::string& path);

// The content of a file, piece by piece, unpacked where it is gzip (seen by its first bytes, not by
// its name). Memory stays near one piece, whatever the file unpacks to.
class FileReader {
 public:
  // Throws InputError where there is no such file, it is a folder or cannot be opened.
  explicit FileReader(const std::string& path);

  // The next piece, cut anywhere, valid until the next call; only the last one is shorter than
  // 1 MiB, and empty means the end. Throws InputError where the file cannot be read, or is gzip
  // that is damaged or cut short.
  std::string_view next();

 private:
  struct Close {
    void operator()(void* file) const;
  };

  std::string path_;
  std::unique_ptr<void, Close> file_;  // of zlib
  std::vector<char> piece_;
};

// Joins pieces that are cut anywhere, and cuts them into lines. A line reaches `take` as it stands
// in its piece, without "\n"; only one that began in an earlier piece is copied.
class LineSplitter {
 public:
  explicit LineSplitter(std::string name) : name_(std::move(name)) {}

  template <class Take>
  void add(std::string_view piece, Take&& take) {
    if (!begun_.empty()) {
      const std::size_t end = piece.find('\n');
      keep(piece.substr(0, end));
      if (end == std::string_view::npos) return;
      take(std::string_view(begun_));
      begun_.clear();
      piece.remove_prefix(end + 1);
    }
    for (std::size_t end = 0; (end = piece.find('\n')) != std::string_view::npos;) {
      take(piece.substr(0, end));
      piece.remove_prefix(end + 1);
    }
    keep(piece);
  }

  // The last line, where no "\n" ends it.
  template <class Take>
  void finish(Take&& take) {
    if (!begun_.empty()) take(std::string_view(begun_));
    begun_.clear();
  }

 private:
  void keep(std::string_view beginning);  // InputError where the line is above 16 MiB

  std::string name_;
  std::string begun_;
};

}  // namespace mapbed
