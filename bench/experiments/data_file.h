#pragma once

#include <string>

namespace mapbed {

// Where a file is: at this path, or else below MAPBED_DATA. Empty: neither.
std::string place_of_data(const std::string& file);

}  // namespace mapbed
