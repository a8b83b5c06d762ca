#pragma once

#include <string>
#include <string_view>

namespace mapbed {

// SHA-256 (FIPS 180-4) as 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

// Of a file as it stands on the disk, packed or not. Throws InputError where it cannot be read.
std::string sha256_of_file(const std::string& path);

}  // namespace mapbed
