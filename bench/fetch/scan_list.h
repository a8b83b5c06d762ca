#pragma once

#include <cstdint>
#include <string>

namespace mapbed {

// The first scans of a bag with one laser, or all for 0, a line each: "t n ranges", in [s] and [m]
// with three decimals and no zeros at the end, as the messages have them; 0 where a range is no
// number. Throws InputError where it cannot be read.
std::string scan_list(const std::string& bag_path, std::uint64_t scans = 0);

}  // namespace mapbed
