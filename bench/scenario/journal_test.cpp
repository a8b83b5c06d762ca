#include "bench/scenario/journal.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <thread>

#include <gmock/gmock.h>

#include "bench/process/folder_lock.h"
#include "core/file/hash.h"
#include "core/file/text_file.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

Journal::Entry entry(int run, double value) {
  return {{.run = run, .seed = 9, .values = {value}, .failure = "a, \"b\""}, {.run = run}};
}

std::string read_bytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Journal, ATornLineDoesNotCountWhereverItWasCut) {
  const TemporaryFolder folder;
  const std::string path = folder.file("journal");
  {
    Journal journal(path, "identity", 1);
    journal.append(entry(3, 0.1));
    journal.append(entry(5, 0.2));
  }
  const std::string whole = read_text_file(path);
  const std::size_t last = whole.rfind('\n', whole.size() - 2) + 1;
  for (std::size_t cut = last; cut <= whole.size(); ++cut) {
    std::ofstream(path, std::ios::binary) << whole.substr(0, cut);
    Journal journal(path, "identity", 1);
    ASSERT_EQ(journal.found().size(), cut == whole.size() ? 2u : 1u) << cut;
    EXPECT_EQ(journal.found()[0].row.run, 3);
    EXPECT_EQ(journal.found()[0].row.values[0], 0.1);
    EXPECT_EQ(journal.found()[0].row.failure, "a, \"b\"");
    journal.append(entry(7, 0.3));  // goes on behind the last whole line
  }
  EXPECT_EQ(Journal(path, "identity", 1).found().back().row.run, 7);
}

TEST(Journal, ALineOfSomethingElseDoesNotCountEvenWithTheRightChecksum) {
  const TemporaryFolder folder;
  const std::string path = folder.file("journal");
  { Journal journal(path, "identity", 1); }
  for (const std::string line :
       {"x,9,,,,,,,,0.1\n", "-1,9,,,,,,,,0.1\n", "3,9,,,,,,,\n", "3,9,,,,,,,,0.1,0.2\n"}) {
    std::ofstream(path, std::ios::app) << sha256(line).substr(0, 16) + "," + line;
    EXPECT_TRUE(Journal(path, "identity", 1).found().empty()) << line;
  }
}

// Lines are written behind those that are there: a byte that were skipped or unpacked in reading
// would set all of them apart from what stands on the disk.
TEST(Journal, ThatSomebodyPackedOrMarkedIsNone) {
  const TemporaryFolder folder;
  const std::string path = folder.file("journal"), packed = folder.file("journal.gz");
  {
    Journal journal(path, "identity", 1);
    journal.append(entry(3, 0.1));
  }
  const std::string whole = read_text_file(path);
  write_text_file(packed, whole);
  for (const std::string& content : {"\xEF\xBB\xBF" + whole, read_bytes(packed)}) {
    std::ofstream(path, std::ios::binary) << content;
    {
      Journal journal(path, "identity", 1);
      EXPECT_TRUE(journal.found().empty());
      journal.append(entry(7, 0.3));
    }
    EXPECT_EQ(Journal(path, "identity", 1).found().size(), 1u);
  }
}

TEST(Journal, RunsOfAnotherConfigurationAreNotMixedIn) {
  const TemporaryFolder folder;
  { Journal journal(folder.file("journal"), "one", 1); }
  EXPECT_INPUT_ERROR(Journal(folder.file("journal"), "other", 1), "--restart");
}

TEST(Journal, IsReadWhileAnotherProgramWritesOn) {
  const TemporaryFolder folder;
  const std::string path = folder.file("journal");
  EXPECT_TRUE(Journal::entries_of(path, 1).empty());
  Journal journal(path, "this", 1);
  journal.append(entry(3, 0.5));
  std::ofstream(path, std::ios::app) << "the begin of a line";
  const auto entries = Journal::entries_of(path, 1);
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_EQ(entries[0].row.run, 3);
  EXPECT_THAT(read_bytes(path), ::testing::EndsWith("the begin of a line")) << "and left as it is";
}

TEST(FolderLock, LetsOneInAtATime) {
  const TemporaryFolder folder;
  EXPECT_FALSE(FolderLock::is_taken(folder.file(".")));
  {
    const FolderLock lock(folder.file("."));
    EXPECT_TRUE(FolderLock::is_taken(folder.file(".")));
    EXPECT_INPUT_ERROR(FolderLock(folder.file(".")), "another run is at work in this folder");
  }
  EXPECT_FALSE(FolderLock::is_taken(folder.file(".")));
  EXPECT_TRUE(std::filesystem::is_empty(folder.file("."))) << "asking makes nothing";
  const FolderLock again(folder.file("."));
}

TEST(FolderLock, WaitsForOneThatHasItForAMoment) {
  const TemporaryFolder folder;
  std::optional<FolderLock> other(std::in_place, folder.file("."));
  std::thread soon([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    other.reset();
  });
  EXPECT_NO_THROW(FolderLock(folder.file("."), 60.0));
  soon.join();
}

}  // namespace
}  // namespace mapbed
