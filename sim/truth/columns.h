#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mapbed {

// Columns of numbers as the blocks of a truth file have them, little-endian on every machine. In
// planes (their number, then all lowest bytes, all next ones, …) gzip packs them to half of what it
// makes of whole numbers; only as many planes are written as the largest number needs.

void append_number(std::string& bytes, std::uint32_t number);
void append_numbers(std::string& bytes, std::span<const double> numbers);
void append_planes(std::string& bytes, std::span<const std::int32_t> numbers);

// Within runs of `length`, each number after the first becomes its difference from the one before;
// and back. Wraps, so that nothing is lost.
void difference(std::span<std::int32_t> numbers, std::size_t length);
void accumulate(std::span<std::int32_t> numbers, std::size_t length);

// What remains of a block's bytes, cut off its front.
class ColumnReader {
 public:
  explicit ColumnReader(std::string_view bytes) : bytes_(bytes) {}

  std::uint32_t number();
  std::vector<double> numbers(std::size_t count);
  std::vector<std::int32_t> planes(std::size_t count);

  // False once more was asked for than there was: what came then was 0 or empty.
  bool ok() const { return ok_; }
  bool at_end() const { return bytes_.empty(); }

 private:
  std::string_view take(std::size_t count, std::size_t size);

  std::string_view bytes_;
  bool ok_ = true;
};

}  // namespace mapbed
