// What scenarios/logs/public/ says of the logs that ship. That they can be made, to the byte, is
// skipped where MAPBED_DATA does not name the folder that holds them and their public files.

#include <cstdlib>
#include <filesystem>
#include <set>

#include <gmock/gmock.h>

#include "bench/fetch/recipes.h"
#include "core/data_path.h"
#include "core/file/hash.h"
#include "core/log/log_description.h"
#include "core/log/public_log.h"
#include "core/testing/source_tree.h"
#include "core/testing/temporary_folder.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

const std::string kLogs = source_tree() + "/scenarios/logs/";

// Of each log that ships: what public/ says is of it, and can be done.
TEST(PublicLogs, AreThoseOfTheDescriptions) {
  std::set<std::string> known;
  for (const Recipe& recipe : recipes()) known.insert(recipe.name);
  int public_logs = 0;
  for (const auto& entry : fs::directory_iterator(kLogs + "public")) {
    SCOPED_TRACE(entry.path());
    const std::string name = entry.path().filename().string();
    const LogDescription log = load_log_description(kLogs + name);
    const PublicLog files = load_public_log(kLogs + name);
    std::set<std::string> stored;
    for (const StoredFile* file : stored_files(log)) stored.insert(file->file);
    for (const MadeFile& made : files.made) {
      EXPECT_TRUE(stored.contains(made.file)) << made.file;
      EXPECT_TRUE(known.contains(made.by)) << made.by;
    }
    EXPECT_NE(can_be_fetched(log), !files.by_hand.empty()) << "steps stand where fetch cannot";
    ++public_logs;
  }
  EXPECT_GE(public_logs, 12);
}

// The public files that are here, by their names in public/.
std::string piece_here(const std::string& data, const std::string& name) {
  if (name == "demo.bag") return data + "/bags/scan_tools_demo.bag";
  return data + "/radish_gfs/" + name;
}

TEST(PublicLogs, AreMadeToTheByteThatResultsRestOn) {
  const char* const data = std::getenv("MAPBED_DATA");
  if (data == nullptr || *data == '\0') GTEST_SKIP() << "MAPBED_DATA is not set";
  const TemporaryFolder folder;
  int made_files = 0;
  for (const std::string& name : data_names("scenarios/logs")) {
    const LogDescription log = load_log_description(kLogs + name + ".yaml");
    const PublicLog files = load_public_log(log.yaml_path);
    for (const StoredFile* stored : stored_files(log)) {
      const MadeFile* const made = files.making(stored->file);
      if (made == nullptr) continue;
      SCOPED_TRACE(stored->file);
      const std::string here = std::string(data) + "/" + stored->file;
      if (!fs::exists(here)) continue;
      EXPECT_EQ(sha256_of_content(here), made->content);
      const std::string piece = piece_here(data, made->piece);
      if (made->by == "copy" || !fs::exists(piece)) continue;
      EXPECT_EQ(sha256_of_file(piece), files.piece_of(*made).sha256);
      const std::string path = folder.file(fs::path(stored->file).filename().string());
      make_file(piece, *made, stored->sha256, path);
      EXPECT_EQ(sha256_of_content(path), made->content);
      const bool has_name_inside = name == "intel_910";  // which no other packing repeats
      if (!has_name_inside) {
        EXPECT_EQ(sha256_of_file(path), stored->sha256);
      }
      ++made_files;
    }
  }
  EXPECT_GE(made_files, 8);
}

}  // namespace
}  // namespace mapbed
