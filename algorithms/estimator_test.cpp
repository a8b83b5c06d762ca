#include "algorithms/estimator.h"

#include <gmock/gmock.h>

#include "algorithms/motion/motion_learning.h"
#include "algorithms/rbpf/grid_slam.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
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

class MethodWithErrorModels : public ::testing::TestWithParam<std::string> {};

TEST_P(MethodWithErrorModels, TakesLearnedOnesByName) {
  GridSlamOptions expected;
  expected.odometry_errors = load_motion_model("pioneer_odometry");
  expected.matching_errors = load_motion_model("pioneer_matching");
  expected.best_only_after_loop = GetParam() == "maximum_likelihood";
  const Settings settings{parse_setting("odometry_errors=pioneer_odometry"),
                          parse_setting("matching_errors=pioneer_matching")};
  EXPECT_EQ(method_by_name(GetParam()).complete_yaml(settings), to_yaml(options_of(expected)));
}

TEST_P(MethodWithErrorModels, TheLaterOfModelAndParameterWins) {
  const Settings model{parse_setting("odometry_errors=pioneer_odometry")};
  const Settings parameter{parse_setting("odometry_errors.turn_bias=0.25")};
  const auto complete = [&](const Settings& first, const Settings& second) {
    Settings both = first;
    both.insert(both.end(), second.begin(), second.end());
    return method_by_name(GetParam()).complete_yaml(both);
  };
  EXPECT_THAT(complete(model, parameter), HasSubstr("turn_bias: 0.25"));
  EXPECT_THAT(complete(parameter, model), Not(HasSubstr("turn_bias: 0.25")));
}

TEST_P(MethodWithErrorModels, AMisspeltModelIsToldWithItsPlace) {
  const Settings settings{{"matching_errors", "pioner_matching", {"my.yaml", 9}}};
  EXPECT_THAT([&] { method_by_name(GetParam()).make(settings, Rng(1)); },
              ThrowsMessage<InputError>("my.yaml:9: unknown motion model 'pioner_matching'; did "
                                        "you mean 'pioneer_matching'?"));
}

TEST_P(MethodWithErrorModels, TheStandardFilterCannotLeaveOdometryOut) {
  const Settings settings{{"proposal", "odometry", {"my.yaml", 4}},
                          {"matcher.use_odometry", "false", {"my.yaml", 7}}};
  EXPECT_THAT([&] { method_by_name(GetParam()).complete_yaml(settings); },
              ThrowsMessage<InputError>(HasSubstr("my.yaml:7: proposal 'odometry' needs the")));
  EXPECT_NO_THROW(method_by_name(GetParam()).complete_yaml({settings[0]}));
  EXPECT_NO_THROW(method_by_name(GetParam()).complete_yaml({settings[1]}));
}

INSTANTIATE_TEST_SUITE_P(Methods, MethodWithErrorModels,
                         ::testing::Values("rbpf", "maximum_likelihood"),
                         [](const auto& method) { return method.param; });

}  // namespace
}  // namespace mapbed
