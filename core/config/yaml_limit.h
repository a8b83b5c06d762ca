#pragma once

#include <cstddef>

namespace mapbed {

// [bytes] of a YAML file that is read. A config.yaml has some 10 KB for each variant; 8 MB of the
// worst YAML (brackets) take 1.2 GB and two seconds.
inline constexpr std::size_t kLargestYaml = std::size_t{8} << 20;

}  // namespace mapbed
