#include "core/file/input_file.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

TEST(InputFile, IsNamedFromTheRootAndHashedAsItStandsOnTheDisk) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("inner"));
  std::ofstream(folder.file("a.txt")) << "abc";
  const InputFile file = input_file(folder.file("inner/../a.txt"));
  EXPECT_EQ(file.path, folder.file("a.txt"));
  // FIPS 180-2, appendix B.1
  EXPECT_EQ(file.sha256, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(InputFile, ThatIsNotThereIsTold) {
  const TemporaryFolder folder;
  EXPECT_INPUT_ERROR(input_file(folder.file("a.txt")), "a.txt: no such file");
  EXPECT_INPUT_ERROR(input_file(folder.file(".")), "is a folder, not a file");
  EXPECT_INPUT_ERROR(input_file("/dev/null"), "is a pipe or a device, which can be read only once");
}

TEST(InputFile, ThatChangesIsTold) {
  const TemporaryFolder folder;
  std::ofstream(folder.file("a.txt")) << "abc";
  const InputFile file = input_file(folder.file("a.txt"));
  check_unchanged(file);
  std::ofstream(folder.file("a.txt")) << "abd";
  EXPECT_INPUT_ERROR(check_unchanged(file), "a.txt: has changed since the runs were planned");
  std::filesystem::remove(folder.file("a.txt"));
  EXPECT_INPUT_ERROR(check_unchanged(file), "a.txt: has changed since the runs were planned");
}

TEST(InputFiles, StandInOrderAndOnce) {
  InputFiles all = {{"/b", "1"}};
  merge({{"/c", "2"}, {"/a", "3"}, {"/b", "1"}}, all);
  EXPECT_EQ(all, (InputFiles{{"/a", "3"}, {"/b", "1"}, {"/c", "2"}}));
}

TEST(HashedFiles, ReadAFileOnce) {
  const TemporaryFolder folder;
  std::ofstream(folder.file("a.txt")) << "abc";
  HashedFiles files;
  const InputFile before = files.at(folder.file("a.txt"));
  std::ofstream(folder.file("a.txt")) << "another text";
  EXPECT_EQ(files.at(folder.file("a.txt")), before);
}

}  // namespace
}  // namespace mapbed
