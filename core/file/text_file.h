#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace mapbed {

// The whole content of a file, unpacked where it is gzip (seen by its first bytes, not by its
// name). Throws InputError where there is no such file, it is a folder, it cannot be read, its gzip
// data are damaged or cut short, or the content is longer than `max_bytes`.
std::string read_text_file(const std::string& path, std::size_t max_bytes = std::size_t{1} << 30);

// Writes a file, gzipped where its name ends in .gz. It gets its name only when it is complete, so
// what stood there before stays where writing fails. Throws InputError where it cannot be written.
void write_text_file(const std::string& path, std::string_view text);

// Cuts the first line off `text` and returns it without its line end ("\n" or "\r\n").
std::string_view next_line(std::string_view& text);

// Cuts the first word (between blanks and tabs) off `line`; empty at its end.
std::string_view next_word(std::string_view& line);

// A finite number that fills the whole word; false where the word is anything else.
bool parse_number(std::string_view word, double& number);

}  // namespace mapbed
