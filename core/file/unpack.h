#pragma once

#include <cstddef>
#include <string>
#include <string_view>

// Packed bytes of a file of another format, such as the chunks of a bag. Whole gzipped files are
// unpacked by FileReader.

namespace mapbed {

struct Unpacked {
  std::string bytes;
  bool is_whole = false;  // false: what came before the damage, the end or `max_bytes`
};

// Memory grows with what is really there, up to `max_bytes`, whatever the packed bytes promise.
Unpacked unpack_bzip2(std::string_view packed, std::size_t max_bytes);
Unpacked unpack_lz4(std::string_view packed, std::size_t max_bytes);   // frames, not bare blocks
Unpacked unpack_zstd(std::string_view packed, std::size_t max_bytes);  // one frame or several

}  // namespace mapbed
