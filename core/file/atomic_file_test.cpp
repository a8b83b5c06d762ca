#include "core/file/atomic_file.h"

#include <filesystem>
#include <fstream>
#include <future>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "core/file/text_file.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace {

// What this thread asked the system for, in order.
thread_local std::vector<std::string> calls;

std::string name_of(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

}  // namespace

// In place of the C library's, for this program alone.
extern "C" int fsync(int file) {
  const std::string link = "/proc/self/fd/" + std::to_string(file);
  calls.push_back("fsync " + name_of(std::filesystem::read_symlink(link).string()));
  return static_cast<int>(syscall(SYS_fsync, file));
}

extern "C" int rename(const char* from, const char* to) noexcept {
  calls.push_back("rename " + name_of(from) + " to " + name_of(to));
  return renameat(AT_FDCWD, from, AT_FDCWD, to);
}

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

// After a power cut a name must not lead to a file whose bytes never got to the disk.
TEST(AtomicFile, IsOnTheDiskBeforeItGetsItsName) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.txt");
  const std::string renamed = "rename .a.txt.unfinished to a.txt";
  calls.clear();
  write_file(path, "new");
  EXPECT_THAT(calls, ::testing::ElementsAre(
                         "fsync .a.txt.unfinished", renamed,
                         "fsync " + name_of(std::filesystem::path(path).parent_path().string())));
  calls.clear();
  write_file(path, "newer", Durability::unsynced);
  EXPECT_THAT(calls, ::testing::ElementsAre(renamed));
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
  EXPECT_INPUT_ERROR(write_file("", ""), "has no name");
}

TEST(AtomicFile, TakesOverWhatAKilledProgramLeft) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.txt");
  std::ofstream(folder.file(".a.txt.unfinished")) << "a longer text that was never finished";
  write_file(path, "new");
  EXPECT_EQ(read_text_file(path), "new");
  EXPECT_EQ(folder.files(), 1u);
}

TEST(AtomicFile, LeavesAloneWhatAnotherOneIsWriting) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.txt");
  AtomicFile slow(path);
  slow.stream() << "slow";
  write_file(path, "quick");
  EXPECT_EQ(read_text_file(path), "quick");
  slow.commit();
  EXPECT_EQ(read_text_file(path), "slow");
  EXPECT_EQ(folder.files(), 1u);
}

TEST(AtomicFile, ALinkStaysAndWhatItPointsToIsWritten) {
  namespace fs = std::filesystem;
  const TemporaryFolder folder;
  fs::create_directory(folder.file("there"));
  write_file(folder.file("there/old.txt"), "old");
  const auto write_through = [&](const std::string& to, const std::string& written) {
    fs::create_symlink(to, folder.file("link"));
    write_file(folder.file("link"), "new");
    EXPECT_TRUE(fs::is_symlink(folder.file("link"))) << to;
    EXPECT_EQ(read_text_file(folder.file(written)), "new") << to;
    fs::remove(folder.file("link"));
  };
  write_through("there/old.txt", "there/old.txt");
  write_through(folder.file("there/not_yet.txt"), "there/not_yet.txt");
  fs::create_symlink("there", folder.file("folder"));
  write_through("folder/second.txt", "there/second.txt");

  fs::create_symlink("circle", folder.file("circle"));
  EXPECT_INPUT_ERROR(write_file(folder.file("circle"), ""), "Too many levels of symbolic links");
}

TEST(AtomicFile, WhatIsNoRegularFileIsWrittenToDirectly) {
  const TemporaryFolder folder;
  const std::string pipe = folder.file("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  auto read = std::async(std::launch::async, [&] { return read_text_file(pipe); });
  check_writable(pipe);  // must not open it: its reader would see an end
  write_file(pipe, std::string(100'000, 'x'));
  EXPECT_EQ(read.get(), std::string(100'000, 'x'));
  EXPECT_EQ(std::filesystem::status(pipe).type(), std::filesystem::file_type::fifo);
  EXPECT_EQ(folder.files(), 1u);
  EXPECT_NO_THROW(write_file("/dev/null", "x"));
  EXPECT_INPUT_ERROR(write_file("/dev/full", "x"),
                     "/dev/full: cannot be written completely; is the disk full?");
}

// As behind "mapbed … -o /dev/stdout >>file", where replacing or truncating the file would lose
// what stands in it.
TEST(AtomicFile, ADescriptorsNameIsTheOpenFile) {
  const TemporaryFolder folder;
  const int file = open(folder.file("a.txt").c_str(), O_CREAT | O_RDWR, 0600);
  ASSERT_EQ(write(file, "before ", 7), 7);
  write_file("/dev/fd/" + std::to_string(file), "now ");
  write_file("/proc/self/fd/" + std::to_string(file), "then");
  close(file);
  EXPECT_EQ(read_text_file(folder.file("a.txt")), "before now then");
  EXPECT_EQ(folder.files(), 1u);
}

TEST(AtomicFile, ALongNameIsWrittenToo) {
  const TemporaryFolder folder;
  write_file(folder.file(std::string(255, 'n')), "x");
  EXPECT_EQ(read_text_file(folder.file(std::string(255, 'n'))), "x");
}

TEST(AtomicFile, CanBeAskedForBeforeTheWork) {
  const TemporaryFolder folder;
  EXPECT_NO_THROW(check_writable(folder.file("a.txt")));
  EXPECT_NO_THROW(check_writable("/dev/null"));
  EXPECT_EQ(folder.files(), 0u);
  EXPECT_INPUT_ERROR(check_writable(folder.file("no/a.txt")), "No such file or directory");
  EXPECT_TRUE(is_special_file("/dev/null"));
  EXPECT_FALSE(is_special_file(folder.file("a.txt")));
}

}  // namespace
}  // namespace mapbed
