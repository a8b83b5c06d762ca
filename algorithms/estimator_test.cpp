#include "algorithms/estimator.h"

#include <gmock/gmock.h>

#include "core/input_error.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(Methods, AreFoundByNameAndListTheirOptions) {
  for (const Method& method : methods()) {
    EXPECT_EQ(method_by_name(method.name).name, method.name);
    EXPECT_FALSE(method.about.empty()) << method.name;
    EXPECT_NO_THROW(method.make({}, Rng(1))) << method.name;
    EXPECT_FALSE(method.complete_yaml({}).empty()) << method.name;
  }
}

TEST(Methods, AMisspeltNameGetsTheNearestOne) {
  EXPECT_THAT(
      [] { method_by_name("odometri"); },
      ThrowsMessage<InputError>(HasSubstr("unknown method 'odometri'; did you mean 'odometry'?")));
}

TEST(Methods, ASettingThatNoOptionTakesIsAnError) {
  const Settings settings{parse_setting("longest_gapp=2 s")};
  EXPECT_THAT([&] { method_by_name("odometry").make(settings, Rng(1)); },
              ThrowsMessage<InputError>(HasSubstr("unknown key 'longest_gapp' in odometry")));
}

TEST(Methods, SettingsReachTheCompleteConfiguration) {
  const Settings settings{parse_setting("longest_gap=250 ms")};
  EXPECT_THAT(method_by_name("odometry").complete_yaml(settings), HasSubstr("longest_gap: 0.25 s"));
}

}  // namespace
}  // namespace mapbed
