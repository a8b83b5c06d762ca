#pragma once

#include <string>
#include <string_view>

#include "core/input_error.h"
#include "sim/truth/truth.h"

namespace mapbed {

// The lines of a truth file before its blocks, see truth_file.h.
std::string header_text(const TruthHeader& header);

class TruthHeaderReader {
 public:
  explicit TruthHeaderReader(const std::string& path) : place_{path, 0} {}

  // True for the last line of the header. A line that is not whole ends the file. Throws InputError
  // with file and line.
  bool take(std::string_view line, bool is_whole);

  TruthHeader header;

 private:
  [[noreturn]] void fail(const std::string& reason) const;
  void check_first_line(std::string_view line) const;
  void expect_index(std::string_view& line, std::size_t expected) const;
  TruthTag tag_in(std::string_view line) const;
  EntityKind kind_of(std::string_view name) const;

  SourceLocation place_;
};

}  // namespace mapbed
