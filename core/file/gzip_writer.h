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

}  // namespace mapbed
