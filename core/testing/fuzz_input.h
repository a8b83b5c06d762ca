#pragma once

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>

#include "core/testing/temporary_folder.h"

// What fuzz targets share.

namespace mapbed {

inline std::string_view fuzz_text(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

// The bytes as a file, for what is read by its path; always the same path, so that messages do not
// differ from run to run.
inline std::string fuzz_file(const std::string& name, const std::uint8_t* data, std::size_t size) {
  static const TemporaryFolder folder;
  std::ofstream(folder.file(name), std::ios::binary) << fuzz_text(data, size);
  return folder.file(name);
}

}  // namespace mapbed
