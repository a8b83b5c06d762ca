#include "core/testing/throws_input_error.h"

#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/input_error.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;

std::string complaint(const std::function<void()>& statement) {
  return throws_input_error(statement, "no such file").message();
}

TEST(ThrowsInputError, TellsWhatWasThrownInstead) {
  EXPECT_INPUT_ERROR(throw InputError("a.yaml: no such file"), "no such file");
  EXPECT_EQ(complaint([] { throw InputError("a.yaml: no such file"); }), "");
  EXPECT_THAT(complaint([] { throw InputError("a.yaml: is empty"); }),
              HasSubstr("'a.yaml: is empty'"));
  EXPECT_THAT(complaint([] { throw InputError("no such file\nat all"); }), HasSubstr("one line"));
  EXPECT_THAT(complaint([] { throw std::runtime_error("no such file"); }), HasSubstr("another"));
  EXPECT_EQ(complaint([] {}), "throws nothing");
}

}  // namespace
}  // namespace mapbed
