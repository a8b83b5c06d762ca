#include "bench/faults/faults.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/faults/testing/small_log.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

Setting set(const std::string& path, const std::string& text) {
  return {path, text, {"test.yaml", 3}};
}

// One setting each that makes it strong enough for a log of a few seconds.
struct Strong {
  std::string name;
  std::string option;
  std::string value;
};

const std::vector<Strong> kStrong{
    {"scale", "by", "0.1"},
    {"drift", "turn_per_meter", "5 deg/m"},
    {"missed_turn", "turn", "30 deg"},
    {"jump", "distance", "1 m"},
    {"restart", "enabled", "true"},
    {"stall", "duration", "3 s"},
    {"lag", "delay", "0.5 s"},
    {"skewed_sweeps", "duration", "1 s"},
    {"missing_beams", "fraction", "0.5"},
    {"no_return_noise", "fraction", "0.5"},
    {"wrong_geometry", "step", "0.1"},
    {"turned_mount", "angle", "5 deg"},
    {"repeated_scans", "duration", "3 s"},
    {"reordered_stamps", "fraction", "1"},
    {"dropped_scans", "fraction", "0.5"},
    {"carried_away", "duration", "3 s"},
};

FaultyLog with(const Strong& strong, std::uint64_t seed = 1) {
  const Settings settings{set("faults." + strong.name + "." + strong.option, strong.value)};
  return broken(small_log(), {}, plan_faults(settings), Rng(seed));
}

TEST(Faults, AreAllTriedHere) {
  EXPECT_EQ(kStrong.size(), faults().size());
  for (const Strong& strong : kStrong) EXPECT_NO_THROW((void)fault_by_name(strong.name));
}

TEST(Faults, ChangeNothingWithTheirDefaults) {
  for (const Fault& fault : faults()) {
    const BrokenLog same = fault.configure({}).make(small_log(), {}, Rng(1));
    EXPECT_TRUE(are_same(same.log, small_log())) << fault.name;
    EXPECT_THAT(same.when, IsEmpty()) << fault.name;
    const BrokenLog none = fault.configure({}).make({}, {}, Rng(1));
    EXPECT_THAT(none.log, IsEmpty()) << fault.name;
  }
}

TEST(Faults, ChangeTheLogAndSayWhen) {
  for (const Strong& strong : kStrong) {
    const FaultyLog faulty = with(strong);
    EXPECT_FALSE(are_same(faulty.log, small_log())) << strong.name;
    ASSERT_EQ(faulty.faults.size(), 1U);
    EXPECT_EQ(faulty.faults[0].name, strong.name);
    EXPECT_FALSE(faulty.faults[0].when.empty()) << strong.name;
    EXPECT_FALSE(faulty.faults[0].told_as.empty()) << strong.name;
  }
}

TEST(Faults, LeaveTheLogInOrderOfTime) {
  for (const Strong& strong : kStrong) {
    const SensorLog log = with(strong).log;
    EXPECT_TRUE(std::is_sorted(
        log.begin(), log.end(),
        [](const Measurement& a, const Measurement& b) { return time_of(a) < time_of(b); }))
        << strong.name;
  }
}

TEST(Faults, OfOneSeedAreTheSame) {
  for (const Strong& strong : kStrong) {
    EXPECT_TRUE(are_same(with(strong, 7).log, with(strong, 7).log)) << strong.name;
  }
}

TEST(Faults, BearAnEmptyLogAndOneOfScansAlone) {
  SensorLog scans;
  for (const LaserScan& scan : scans_of(small_log())) scans.push_back(scan);
  for (const Strong& strong : kStrong) {
    const PlannedFaults plan =
        plan_faults({set("faults." + strong.name + "." + strong.option, strong.value)});
    EXPECT_THAT(broken({}, {}, plan, Rng(1)).log, IsEmpty()) << strong.name;
    EXPECT_NO_THROW((void)broken(scans, {}, plan, Rng(1))) << strong.name;
  }
}

TEST(Faults, AreAppliedTogetherInTheOrderOfTheTable) {
  const PlannedFaults plan =
      plan_faults({set("faults.lag.delay", "1 s"), set("faults.scale.by", "0.1")});
  ASSERT_EQ(plan.planned.size(), 2U);
  EXPECT_EQ(plan.planned[0].name, "scale");
  const FaultyLog faulty = broken(small_log(), {}, plan, Rng(1));
  EXPECT_EQ(faulty.faults.size(), 2U);
  EXPECT_EQ(readings_of(faulty.log)[1].time, 102.0);
  EXPECT_DOUBLE_EQ(readings_of(faulty.log)[1].odometry_from_robot.x, 1.1);
}

TEST(Faults, StandCompleteInTheRecord) {
  const PlannedFaults plan = plan_faults({set("faults.stall.duration", "2 s")});
  EXPECT_THAT(plan.complete_yaml, HasSubstr("faults.stall.duration: 2 s"));
  EXPECT_THAT(plan.complete_yaml, HasSubstr("faults.stall.at: []"));
  EXPECT_EQ(plan_faults({}).complete_yaml, "");
}

TEST(Faults, WrongOnesAreToldWithTheirPlace) {
  EXPECT_INPUT_ERROR(plan_faults({set("faults.stal.duration", "1 s")}),
                     "test.yaml:3: unknown fault 'stal'; did you mean 'stall'?");
  EXPECT_INPUT_ERROR(plan_faults({set("faults.stall", "1 s")}),
                     "the fault 'stall' has options, not a value");
  EXPECT_INPUT_ERROR(plan_faults({set("faults.stall.seconds", "1 s")}), "unknown key 'seconds'");
  EXPECT_INPUT_ERROR(plan_faults({set("faults.stall.duration", "-1 s")}), "'-1 s' is too small");
}

}  // namespace
}  // namespace mapbed
