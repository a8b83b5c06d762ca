#include "bench/fetch/recipes.h"

#include <fmt/format.h>

#include "bench/fetch/corrected_log.h"
#include "bench/fetch/scan_list.h"
#include "core/config/suggestion.h"
#include "core/file/atomic_file.h"
#include "core/file/file_reader.h"
#include "core/file/gzip_writer.h"
#include "core/file/hash.h"
#include "core/input_error.h"
#include "core/log/public_log.h"

namespace mapbed {
namespace {

std::string unpacked_bytes_of(const std::string& path) {
  FileReader file(path);
  std::string bytes;
  for (std::string_view piece; !(piece = file.next()).empty();) bytes += piece;
  return bytes;
}

const Recipe& recipe_of(const MadeFile& made) {
  std::vector<std::string> names;
  for (const Recipe& recipe : recipes()) {
    if (recipe.name == made.by) return recipe;
    names.emplace_back(recipe.name);
  }
  throw InputError({made.file}, "there is no way called " + in_quotes(made.by) + " to make it",
                   suggestion(made.by, names));
}

// As it was packed when results were made of it, where zlib still packs so.
std::string packed(const std::string& content, const std::string& expected) {
  for (const GzipForm form : {GzipForm::python, GzipForm::gzip}) {
    std::string bytes = gzipped(content, form);
    if (sha256(bytes) == expected) return bytes;
  }
  return gzipped(content, GzipForm::plain);
}

}  // namespace

const std::vector<Recipe>& recipes() {
  static const std::vector<Recipe> all{
      {"copy", "what lies there",
       [](const std::string& piece, const MadeFile&) { return unpacked_bytes_of(piece); }},
      {"chained_odometry", "a log that GMapping has corrected, with the odometry that it was given",
       [](const std::string& piece, const MadeFile& made) {
         return chained_odometry(read_corrected_log(piece), made);
       }},
      {"corrected_poses", "the poses that GMapping found",
       [](const std::string& piece, const MadeFile& made) {
         return corrected_poses(read_corrected_log(piece), made);
       }},
      {"scan_list", "the scans of a bag, a line each",
       [](const std::string& piece, const MadeFile& made) { return scan_list(piece, made.scans); }},
  };
  return all;
}

void make_file(const std::string& piece_path, const MadeFile& made, const std::string& expected,
               const std::string& path) {
  std::string content;
  for (const std::string& line : made.header) content += line + '\n';
  content += recipe_of(made).make(piece_path, made);
  const std::string of_content = sha256(content);
  if (of_content != made.content) {
    throw InputError(
        {path},
        fmt::format("what was made of {} is not what shall be in it: its SHA-256 is {}…, not {}…",
                    made.piece, of_content.substr(0, 12), made.content.substr(0, 12)),
        "last digits may differ on another kind of processor; name a folder or a mirror that has "
        "the file with --from");
  }
  write_file(path, path.ends_with(".gz") ? packed(content, expected) : content);
}

}  // namespace mapbed
