#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace mapbed {

// A gzip file, written piece by piece; it gets its name only when it is complete.
class GzipWriter {
 public:
  explicit GzipWriter(const std::string& path);  // InputError where it cannot be written
  ~GzipWriter();                                 // without commit(): as if nothing had been written
  GzipWriter(const GzipWriter&) = delete;
  GzipWriter& operator=(const GzipWriter&) = delete;

  void write(std::string_view bytes);
  void commit();  // once, in the end. InputError where not all of it could be written

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// A whole gzip file, packed as strongly as can be, without name and time. `plain` is what the
// program writes; the others are what other programs write, to the byte: Python's GzipFile, and
// gzip -9n, whose own packing is nearly always that of zlib with more memory. Another version of
// zlib may pack otherwise.
enum class GzipForm : int { plain, python, gzip };
std::string gzipped(std::string_view bytes, GzipForm form);

}  // namespace mapbed
