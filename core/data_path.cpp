#include "core/data_path.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "core/config/suggestion.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

fs::path beside_program() {
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed);
  return failed ? fs::path() : program.parent_path().parent_path() / "share" / "mapbed";
}

bool looks_like_path(const std::string& text) {
  return text.find('/') != std::string::npos || text.ends_with(".yaml");
}

bool is_surely_path(const std::string& text) {
  return text.ends_with(".yaml") || text.starts_with("./") || text.starts_with("../");
}

// Empty where it is not in that folder.
fs::path path_below(const fs::path& folder, const fs::path& path) {
  const fs::path below = path.lexically_relative(fs::absolute(folder).lexically_normal());
  return !below.empty() && *below.begin() != ".." ? below : fs::path();
}

// Of what lies in data_home(), which may be a source tree with anything in it: the data files
// alone.
bool is_shipped(const fs::path& below_home) {
  for (const char* folder : {"algorithms/motion/motion_models", "algorithms/people/people_models",
                             "algorithms/rfid/rfid_models", "robots", "scenarios", "worlds"}) {
    const fs::path inner = below_home.lexically_relative(folder);
    if (!inner.empty() && *inner.begin() != "..") return true;
  }
  return false;
}

}  // namespace

std::string with_whole_path(const std::string& value, const SourceLocation& place) {
  const bool is_number = value.find_first_not_of("0123456789.+-eE") == std::string::npos;
  const bool may_be_path = !is_number && value.find_first_of("/.") != std::string::npos;
  if (!may_be_path || value.find_first_of("\n[{") != std::string::npos) return value;
  const fs::path folder = place.line > 0 ? fs::path(place.file).parent_path() : fs::path();
  const fs::path path = fs::absolute(folder / value).lexically_normal();
  const bool leads_somewhere = is_file(path) || (value.find('/') != value.npos && is_folder(path));
  return is_surely_path(value) || leads_somewhere ? path.string() : value;
}

const FilesCalledSo& yaml_files() {
  static const FilesCalledSo files{.place = {}, .endings = {".yaml"}};
  return files;
}

std::string name_or_path_suggestion(const std::string& word, const std::vector<std::string>& names,
                                    const FilesCalledSo& files) {
  const SourceLocation& place = files.place;
  const fs::path folder = place.line > 0 ? fs::path(place.file).parent_path() : fs::path();
  for (const std::string& ending : files.endings) {
    if (is_file(folder / (word + ending))) return "did you mean ./" + word + ending + "?";
  }
  return suggestion(word, names);
}

std::filesystem::path data_home() {
  if (const char* home = std::getenv("MAPBED_HOME"); home != nullptr && *home != '\0') {
    if (is_folder(home)) return home;
    throw InputError(std::string("MAPBED_HOME is '") + home +
                     "', which is not a folder; unset it or name the folder that holds robots/");
  }
  for (const fs::path& home :
       {beside_program(), fs::path(MAPBED_DATA_INSTALL_DIR), fs::path(MAPBED_DATA_SOURCE_DIR)}) {
    if (is_folder(home / "robots")) return home;
  }
  throw InputError(
      "the data files (robots/, scenarios/) were not found; set MAPBED_HOME to the "
      "folder that holds them");
}

std::filesystem::path find_data_file(const std::string& kind, const std::string& folder,
                                     const std::string& name_or_path, const FilesCalledSo& files) {
  if (looks_like_path(name_or_path)) {
    if (is_file(name_or_path)) return name_or_path;
    throw InputError(name_or_path + ": there is no such file; give the path of a " + kind +
                     " file or one of the names that 'mapbed list' shows");
  }
  const fs::path path = data_home() / folder / (name_or_path + ".yaml");
  if (is_file(path)) return path;
  throw InputError("unknown " + kind + " " + in_quotes(name_or_path) + "; " +
                   name_or_path_suggestion(name_or_path, data_names(folder), files));
}

std::string portable_path(const std::string& path) {
  const fs::path shipped = path_below(data_home(), path);
  if (!shipped.empty() && is_shipped(shipped)) return shipped.string();
  const char* const data = std::getenv("MAPBED_DATA");
  if (data == nullptr || *data == '\0') return path;
  const fs::path stored = path_below(data, path);
  return stored.empty() ? path : stored.string();
}

std::vector<std::string> data_names(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(data_home() / folder, failed)) {
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace mapbed
