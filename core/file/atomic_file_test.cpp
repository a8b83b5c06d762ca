#include "core/file/atomic_file.h"

#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "core/file/text_file.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

TEST(AtomicFile, IsThereOnlyWhenItIsComplete) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.txt");
  write_file(path, "old");
  {
    AtomicFile file(path);
    file.stream() << "new";
    EXPECT_EQ(read_text_file(path), "old");
    file.commit();
  }
  EXPECT_EQ(read_text_file(path), "new");
  EXPECT_EQ(folder.files(), 1u);
}

TEST(AtomicFile, LeavesNothingBehindWhereItIsGivenUp) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.txt");
  { AtomicFile(path).stream() << "half"; }
  EXPECT_EQ(folder.files(), 0u);
}

TEST(AtomicFile, ManyThreadsMayWriteTheSameFile) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.txt");
  const std::string content(10'000, 'x');
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i) threads.emplace_back([&] { write_file(path, content); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(read_text_file(path), content);
  EXPECT_EQ(folder.files(), 1u);
}

TEST(AtomicFile, SaysWhereItCannotBeWritten) {
  const TemporaryFolder folder;
  EXPECT_INPUT_ERROR(write_file(folder.file("no/a.txt"), ""),
                     "no/a.txt: cannot be written: No such file or directory");
  EXPECT_INPUT_ERROR(write_file(folder.file(""), ""), "is a folder");
  EXPECT_INPUT_ERROR(write_file("/dev/null", ""), "is not a regular file");
}

}  // namespace
}  // namespace mapbed
