#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace mapbed {

// Hands over a text file, plain or gzipped, piece by piece; each piece ends with a whole line.
// Memory stays near one piece (1 MiB), whatever the file unpacks to. Throws InputError for a file
// that is not there, cannot be unpacked, is cut short, has a line above 16 MiB or more than
// max_text bytes in all.
void for_each_text_block(const std::string& path, double max_text,
                         const std::function<void(std::string_view)>& take);

}  // namespace mapbed
