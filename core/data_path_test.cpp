#include "core/data_path.h"

#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace mapbed
