#include "bench/experiments/data_file.h"

#include <cstdlib>
#include <filesystem>

namespace mapbed {

namespace fs = std::filesystem;

std::string place_of_data(const std::string& file) {
  if (fs::is_regular_file(file)) return file;
  const char* const data = std::getenv("MAPBED_DATA");
  if (data == nullptr || *data == '\0') return {};
  const fs::path below = fs::path(data) / file;
  return fs::is_regular_file(below) ? below.string() : std::string();
}

}  // namespace mapbed
