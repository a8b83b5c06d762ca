// A container gets the packages that ./mapbed would install, and no others.

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "core/testing/source_tree.h"

namespace mapbed {
namespace {

std::ifstream opened(const char* name) {
  return std::ifstream(std::filesystem::path(source_tree()) / name);
}

std::vector<std::string> packages_of_program() {
  std::ifstream file = opened("debian-packages.txt");
  std::vector<std::string> names;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string group, name;
    if (words >> group >> name && group == "program") names.push_back(name);
  }
  return names;
}

// Those that follow apt-get install, one a line.
std::vector<std::string> packages_of_container() {
  std::ifstream file = opened("Containerfile");
  std::vector<std::string> names;
  bool installs = false;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string first;
    words >> first;
    if (first == "&&") installs = false;
    if (installs) names.push_back(first);
    if (line.find("apt-get install") != line.npos) installs = true;
  }
  return names;
}

TEST(Containerfile, InstallsThePackagesOfTheProgram) {
  ASSERT_FALSE(packages_of_program().empty());
  EXPECT_EQ(packages_of_container(), packages_of_program());
}

TEST(Containerfile, IsOfTheSystemThatTheProjectIsBuiltOn) {
  std::ifstream file = opened("Containerfile");
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_THAT(text.str(), ::testing::HasSubstr("\nFROM debian:12\n"));
}

}  // namespace
}  // namespace mapbed
