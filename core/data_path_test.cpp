#include "core/data_path.h"

#include <cstdlib>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/input_error.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

// Sets MAPBED_HOME for the length of a test.
class Home {
 public:
  explicit Home(const std::string& path) { ::setenv("MAPBED_HOME", path.c_str(), 1); }
  ~Home() { ::unsetenv("MAPBED_HOME"); }
};

TEST(DataPath, IsTheSourceTreeInABuild) {
  EXPECT_TRUE(std::filesystem::exists(data_home() / "robots" / "pioneer.yaml"));
}

TEST(DataPath, TheEnvironmentComesFirst) {
  const Home home(::testing::TempDir());
  EXPECT_EQ(data_home(), std::filesystem::path(::testing::TempDir()));
}

TEST(DataPath, AWrongEnvironmentIsNamed) {
  const Home home("/no/such/folder");
  EXPECT_INPUT_ERROR(data_home(),
                     "MAPBED_HOME is '/no/such/folder', which is not a folder; unset it");
}

TEST(DataPath, FindsByNameAndByPath) {
  const auto by_name = find_data_file("robot", "robots", "pioneer");
  EXPECT_EQ(by_name.filename(), "pioneer.yaml");
  EXPECT_EQ(find_data_file("robot", "robots", by_name.string()), by_name);
  EXPECT_THAT(data_names("robots"), ::testing::Contains("pioneer"));
}

TEST(DataPath, UnknownNamesGetASuggestion) {
  EXPECT_INPUT_ERROR(find_data_file("robot", "robots", "pionier"),
                     "unknown robot 'pionier'; did you mean 'pioneer'?");
  EXPECT_INPUT_ERROR(find_data_file("robot", "robots", "my/robot.yaml"),
                     "my/robot.yaml: there is no such file");
}

TEST(DataPath, AnUnknownNameMayMeanAFileThatIsCalledSo) {
  const TemporaryFolder folder;
  const FilesCalledSo beside{.place = {folder.file("x.yaml"), 3}, .endings = {".yaml", ".log"}};
  EXPECT_EQ(name_or_path_suggestion("mine", {"mines"}, beside), "did you mean 'mines'?");
  std::ofstream(folder.file("mine.log")) << "a log";
  EXPECT_EQ(name_or_path_suggestion("mine", {"mines"}, beside), "did you mean ./mine.log?");
  std::ofstream(folder.file("mine.yaml")) << "a description";
  EXPECT_EQ(name_or_path_suggestion("mine", {"mines"}, beside), "did you mean ./mine.yaml?");
  EXPECT_INPUT_ERROR(find_data_file("robot", "robots", "mine", beside),
                     "unknown robot 'mine'; did you mean ./mine.yaml?");
}

TEST(WholePath, CountsFromTheFolderOfTheFileThatNamesIt) {
  const SourceLocation place{"/home/ann/scenarios/x.yaml", 3};
  EXPECT_EQ(with_whole_path("room.yaml", place), "/home/ann/scenarios/room.yaml");
  EXPECT_EQ(with_whole_path("../worlds/room.yaml", place), "/home/ann/worlds/room.yaml");
  EXPECT_EQ(with_whole_path("/data/room.yaml", place), "/data/room.yaml");
  EXPECT_EQ(with_whole_path("./drive.log", place), "/home/ann/scenarios/drive.log");
}

TEST(WholePath, OnTheCommandLineCountsFromTheWorkingFolder) {
  EXPECT_EQ(with_whole_path("./a/room.yaml", {"--set world=./a/room.yaml", 0}),
            (std::filesystem::current_path() / "a/room.yaml").string());
}

TEST(PortablePath, CountsFromTheFolderOfTheDataFiles) {
  const Home home("/tmp");
  EXPECT_EQ(portable_path("/tmp/robots/b21r.yaml"), "robots/b21r.yaml");
  EXPECT_EQ(portable_path("/tmp/robots/sensors/s300.yaml"), "robots/sensors/s300.yaml");
  EXPECT_EQ(portable_path("/home/ann/b21r.yaml"), "/home/ann/b21r.yaml");
  EXPECT_EQ(portable_path("/tmpfs/robots/b21r.yaml"), "/tmpfs/robots/b21r.yaml");
}

TEST(PortablePath, OfEveryParameterFileIsTheSameOnEveryMachine) {
  int files = 0;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(data_home() / "algorithms")) {
    if (entry.path().extension() != ".yaml") continue;
    ++files;
    EXPECT_TRUE(portable_path(entry.path().string()).starts_with("algorithms/")) << entry.path();
  }
  EXPECT_GT(files, 5) << "looked in the wrong place";
}

// From another source tree it would lead to another file, or to none.
TEST(PortablePath, OfSomebodysFileInTheSourceTreeIsWhole) {
  const Home home("/tmp");
  for (const char* own : {"/tmp/my_world.yaml", "/tmp/build/my.yaml", "/tmp/build/robots/my.yaml",
                          "/tmp/robots.yaml"}) {
    EXPECT_EQ(portable_path(own), own);
  }
}

TEST(WholePath, LeavesAloneWhatNamesNoFile) {
  const TemporaryFolder folder;
  const SourceLocation place{folder.file("x.yaml"), 1};
  for (const char* value :
       {"office", "0.5 m/s", "1.5", "drive.log", "logs/drive.log", "[1.5, 2]"}) {
    EXPECT_EQ(with_whole_path(value, place), value);
  }
  std::ofstream(folder.file("drive.log")) << "a log";
  std::ofstream(folder.file("1.5")) << "a file by the name of a number";
  EXPECT_EQ(with_whole_path("1.5", place), "1.5");
  EXPECT_EQ(with_whole_path("drive.log", place), folder.file("drive.log"));
}

TEST(WholePath, OfAFolderIsToldByItsSlash) {
  const TemporaryFolder folder;
  const SourceLocation place{folder.file("x.yaml"), 1};
  std::filesystem::create_directories(folder.file("bags/drive.1"));
  EXPECT_EQ(with_whole_path("bags/drive.1", place), folder.file("bags/drive.1"));
  EXPECT_EQ(with_whole_path("bags", place), "bags");
}

}  // namespace
}  // namespace mapbed
