#pragma once

#include <fstream>
#include <string>
#include <string_view>

namespace mapbed {

// A file that is there complete or not at all: written under another name in the same folder, which
// commit() changes to the right one. An older file of that name stays until then. Guards against a
// program that fails or is killed, not against a power cut.
class AtomicFile {
 public:
  explicit AtomicFile(const std::string& path);  // InputError where it cannot be written
  ~AtomicFile();                                 // without commit(): as if nothing had been written
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  std::ostream& stream() { return stream_; }
  void commit();  // once, in the end. InputError where not all of it could be written (disk full)

 private:
  std::string path_;
  std::string unfinished_;  // empty after commit
  std::ofstream stream_;
};

// The whole file at once.
void write_file(const std::string& path, std::string_view content);

}  // namespace mapbed
