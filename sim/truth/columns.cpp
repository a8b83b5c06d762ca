#include "sim/truth/columns.h"

#include <algorithm>
#include <bit>

#include "core/check.h"

namespace mapbed {
namespace {

constexpr int kMostPlanes = 4;

template <class Unsigned>
void append_little_endian(std::string& bytes, Unsigned number) {
  for (std::size_t k = 0; k < sizeof(Unsigned); ++k) {
    bytes.push_back(static_cast<char>(number >> (8 * k)));
  }
}

template <class Unsigned>
Unsigned little_endian(std::string_view bytes) {
  Unsigned number = 0;
  for (std::size_t k = 0; k < sizeof(Unsigned); ++k) {
    number |= static_cast<Unsigned>(static_cast<unsigned char>(bytes[k])) << (8 * k);
  }
  return number;
}

// How many bytes hold every number, sign included.
std::size_t planes_for(std::span<const std::int32_t> numbers) {
  std::uint32_t bits = 0;  // that differ from the sign's in any of them
  for (const std::int32_t number : numbers) {
    bits |= static_cast<std::uint32_t>(number < 0 ? ~number : number);
  }
  return std::bit_width(bits) / 8 + 1;
}

}  // namespace

void append_number(std::string& bytes, std::uint32_t number) {
  append_little_endian(bytes, number);
}

void append_numbers(std::string& bytes, std::span<const double> numbers) {
  for (const double number : numbers) {
    append_little_endian(bytes, std::bit_cast<std::uint64_t>(number));
  }
}

void append_planes(std::string& bytes, std::span<const std::int32_t> numbers) {
  const std::size_t planes = planes_for(numbers);
  bytes.push_back(static_cast<char>(planes));
  for (std::size_t k = 0; k < planes; ++k) {
    for (const std::int32_t number : numbers) {
      bytes.push_back(static_cast<char>(static_cast<std::uint32_t>(number) >> (8 * k)));
    }
  }
}

void difference(std::span<std::int32_t> numbers, std::size_t length) {
  CHECK(numbers.empty() || (length > 0 && numbers.size() % length == 0));
  for (std::size_t begin = 0; begin < numbers.size(); begin += length) {
    for (std::size_t i = begin + length - 1; i > begin; --i) {
      numbers[i] = static_cast<std::int32_t>(static_cast<std::uint32_t>(numbers[i]) -
                                             static_cast<std::uint32_t>(numbers[i - 1]));
    }
  }
}

void accumulate(std::span<std::int32_t> numbers, std::size_t length) {
  CHECK(numbers.empty() || (length > 0 && numbers.size() % length == 0));
  for (std::size_t begin = 0; begin < numbers.size(); begin += length) {
    for (std::size_t i = begin + 1; i < begin + length; ++i) {
      numbers[i] = static_cast<std::int32_t>(static_cast<std::uint32_t>(numbers[i]) +
                                             static_cast<std::uint32_t>(numbers[i - 1]));
    }
  }
}

// Counts come from the file: they may be anything.
std::string_view ColumnReader::take(std::size_t count, std::size_t size) {
  if (!ok_ || count > bytes_.size() / std::max<std::size_t>(size, 1)) {
    ok_ = false;
    return {};
  }
  const std::string_view taken = bytes_.substr(0, count * size);
  bytes_.remove_prefix(count * size);
  return taken;
}

std::uint32_t ColumnReader::number() {
  const std::string_view bytes = take(1, 4);
  return ok_ ? little_endian<std::uint32_t>(bytes) : 0;
}

std::vector<double> ColumnReader::numbers(std::size_t count) {
  const std::string_view bytes = take(count, 8);
  std::vector<double> result;
  result.reserve(bytes.size() / 8);
  for (std::size_t i = 0; i < bytes.size(); i += 8) {
    result.push_back(std::bit_cast<double>(little_endian<std::uint64_t>(bytes.substr(i, 8))));
  }
  return result;
}

std::vector<std::int32_t> ColumnReader::planes(std::size_t count) {
  const std::string_view width = take(1, 1);
  const auto planes = static_cast<unsigned char>(ok_ ? width[0] : 0);
  ok_ = ok_ && planes >= 1 && planes <= kMostPlanes;
  const std::string_view bytes = take(count, planes);
  if (!ok_) return {};
  std::vector<std::uint32_t> numbers(count);
  for (std::size_t k = 0; k < planes; ++k) {
    const char* const plane = bytes.data() + k * count;
    for (std::size_t i = 0; i < count; ++i) {
      numbers[i] |= static_cast<std::uint32_t>(static_cast<unsigned char>(plane[i])) << (8 * k);
    }
  }
  // The highest plane has the sign.
  const int above = 8 * (kMostPlanes - planes);
  std::vector<std::int32_t> result(count);
  for (std::size_t i = 0; i < count; ++i) {
    result[i] = static_cast<std::int32_t>(numbers[i] << above) >> above;
  }
  return result;
}

}  // namespace mapbed
