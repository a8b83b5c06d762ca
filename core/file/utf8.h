#pragma once

#include <string>
#include <string_view>

namespace mapbed {

// Whether bytes are text in UTF-8 (RFC 3629). Names of files need not be.
bool is_utf8(std::string_view bytes);

// Bytes as such text: each that belongs to none becomes "\xE4", what is text stays as it is.
std::string escaped_utf8(std::string_view bytes);

}  // namespace mapbed
