#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace mapbed {

// SHA-256 (FIPS 180-4) of bytes that come piece by piece.
class Sha256 {
 public:
  void add(std::string_view bytes);
  std::string digits();  // 64 hexadecimal ones; once, at the end

 private:
  std::array<std::uint32_t, 8> state_ = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                         0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::string rest_;  // less than one block
  std::uint64_t bytes_ = 0;
};

std::string sha256(std::string_view bytes);

// Of a file as it stands on the disk, packed or not. Throws InputError where it cannot be read.
std::string sha256_of_file(const std::string& path);

// Of what it unpacks to. Throws InputError where it is gzip that is damaged, too.
std::string sha256_of_content(const std::string& path);

std::uint32_t crc32(std::string_view bytes);  // as in ZIP, PNG and MCAP

}  // namespace mapbed
