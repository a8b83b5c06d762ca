#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace mapbed {

// The whole content of a file, plain or gzipped, without a byte order mark. Throws InputError where
// it cannot be read (FileReader) or the content is longer than `max_bytes`.
std::string read_text_file(const std::string& path, std::size_t max_bytes = std::size_t{1} << 28);

// Writes a file, gzipped where its name ends in .gz. It gets its name only when it is complete, so
// what stood there before stays where writing fails. Throws InputError where it cannot be written.
void write_text_file(const std::string& path, std::string_view text);

}  // namespace mapbed
