#include "core/failure_text.h"

#include <filesystem>
#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>

#include "core/input_error.h"

namespace mapbed {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

template <class Fail>
std::string text_of(Fail fail) {
  try {
    fail();
  } catch (const std::exception& error) {
    return failure_text(error);
  }
  return {};
}

TEST(FailureText, IsThatOfAnInputErrorAsItStands) {
  EXPECT_EQ(text_of([] {
              throw InputError({"a.log", 3}, "reason", "remedy");
            }),
            "a.log:3: reason; remedy");
}

TEST(FailureText, NamesFileReasonAndRemedyWhereTheFileSystemFailed) {
  const auto fail = [] {
    for ([[maybe_unused]] const auto& e : std::filesystem::directory_iterator("/no/such/place")) {
    }
  };
  EXPECT_THAT(text_of(fail), AllOf(StartsWith("/no/such/place: cannot be used: No such file"),
                                   HasSubstr("; check"), Not(HasSubstr("filesystem error"))));
}

TEST(FailureText, SaysOutOfMemoryAndNotTheNameOfAFunction) {
  const auto too_long = [] { std::vector<int>().resize(std::vector<int>().max_size() + 1); };
  EXPECT_THAT(text_of(too_long), StartsWith("out of memory; "));
  EXPECT_THAT(text_of([] { throw std::bad_alloc(); }), StartsWith("out of memory; "));
}

TEST(FailureText, SaysWhereNobodyIsToBlameButUs) {
  EXPECT_THAT(text_of([] { throw std::logic_error("stoi"); }),
              AllOf(HasSubstr("bug in mapbed"), HasSubstr("stoi")));
}

}  // namespace
}  // namespace mapbed
