// CHECK says what must hold; what has an effect stands before it, where a reader sees it and where
// it would stay if checks were ever taken out. This test reads each CHECK of the tree.

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>

#include "core/testing/source_tree.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

// What stands between the brackets of each CHECK(…).
std::vector<std::string> check_arguments(std::string_view text) {
  std::vector<std::string> arguments;
  constexpr std::string_view kCheck = " CHECK(";
  for (std::size_t at = text.find(kCheck); at != text.npos; at = text.find(kCheck, at + 1)) {
    const std::size_t begin = at + kCheck.size();
    std::size_t end = begin;
    for (int open = 1; end < text.size() && open > 0; ++end) {
      open += text[end] == '(' ? 1 : text[end] == ')' ? -1 : 0;
    }
    arguments.emplace_back(text.substr(begin, end - begin - 1));
  }
  return arguments;
}

// Signs of an effect: counting, assigning, functions that do something and say how it went.
bool has_effect(const std::string& argument) {
  constexpr std::array<std::string_view, 9> kEffects = {
      "++", "--", " = ", "+= ", "-= ", "deflate", "parse_number(", "read_number(", ".insert("};
  return std::any_of(kEffects.begin(), kEffects.end(),
                     [&](std::string_view sign) { return argument.find(sign) != argument.npos; });
}

TEST(CheckArgument, IsFoundToItsLastBracketAndJudged) {
  EXPECT_THAT(check_arguments("{ CHECK(f(a, (b)) > 0); CHECK(++n < 3); }"),
              ElementsAre("f(a, (b)) > 0", "++n < 3"));
  EXPECT_FALSE(has_effect("a == b && c <= d && e != f"));
  EXPECT_TRUE(has_effect("++n < 3"));
  EXPECT_TRUE(has_effect("(code = deflateInit(&s)) == Z_OK"));
}

TEST(CheckArgument, HasNoEffectAnywhereInTheTree) {
  std::vector<std::string> found;
  int read = 0;
  for (const char* folder : {"core", "worlds", "robots", "algorithms", "sim", "bench"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(source_tree()) / folder)) {
      const std::string name = entry.path().filename().string();
      const bool is_source = name.ends_with(".cpp") || name.ends_with(".h");
      if (!is_source || name == "check_argument_test.cpp") continue;
      std::ifstream file(entry.path());
      for (const std::string& argument :
           check_arguments(std::string{std::istreambuf_iterator<char>(file), {}})) {
        ++read;
        if (has_effect(argument)) found.push_back(name + ": " + argument);
      }
    }
  }
  EXPECT_GT(read, 50) << "looked in the wrong place: " << source_tree();
  EXPECT_THAT(found, IsEmpty());
}

}  // namespace
}  // namespace mapbed
