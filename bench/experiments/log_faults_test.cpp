#include "bench/experiments/log_faults.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/sources/shared_work.h"

namespace mapbed {
namespace {

const FaultInLog kJump{"jump", {RemarkKind::odometry_jump}, {{10.0, 11.0}}};

TEST(ToldFaults, AreThoseThatARemarkOfTheRightKindNamesAtTheRightTime) {
  const auto told = [](RemarkKind kind, std::optional<TimeInterval> when) {
    return told_faults({kJump}, {{RemarkKind::note, "n"}, {kind, "r", when}}, 2.0);
  };
  EXPECT_EQ(told(RemarkKind::odometry_jump, TimeInterval{10.5, 10.5}), 1.0);
  EXPECT_EQ(told(RemarkKind::odometry_jump, TimeInterval{8.0, 8.0}), 1.0);
  EXPECT_EQ(told(RemarkKind::odometry_jump, TimeInterval{13.0, 14.0}), 1.0);
  EXPECT_EQ(told(RemarkKind::odometry_jump, TimeInterval{13.1, 14.0}), 0.0);
  EXPECT_EQ(told(RemarkKind::odometry_jump, TimeInterval{0.0, 7.9}), 0.0);
  EXPECT_EQ(told(RemarkKind::odometry_jump, TimeInterval{0.0, 99.0}), 1.0);
  EXPECT_EQ(told(RemarkKind::odometry_jump, {}), 1.0) << "about the whole log";
  EXPECT_EQ(told(RemarkKind::lost, TimeInterval{10.5, 10.5}), 0.0);
}

TEST(ToldFaults, AreAFractionOfThoseThatFoundAPlace) {
  const FaultInLog stall{"stall", {RemarkKind::odometry_stall}, {{20.0, 21.0}}};
  const FaultInLog nowhere{"stall", {RemarkKind::odometry_stall}, {}};
  const std::vector<Remark> remarks{{RemarkKind::odometry_jump, "r", TimeInterval{10.0, 10.0}}};
  EXPECT_EQ(told_faults({kJump, stall}, remarks, 2.0), 0.5);
  EXPECT_EQ(told_faults({kJump, nowhere}, remarks, 2.0), 1.0);
  EXPECT_TRUE(std::isnan(told_faults({nowhere}, remarks, 2.0)));
  EXPECT_TRUE(std::isnan(told_faults({}, remarks, 2.0)));
}

// Odometry and a scan each second, along x at 1 m/s; the relations span 5 m each.
class OdometryInABrokenLog : public ::testing::Test {
 protected:
  OdometryInABrokenLog() {
    for (int i = 0; i <= 20; ++i) {
      const Pose2 pose{1.0 * i, 0.0, 0.0};
      input_.log.push_back(Odometry{1.0 * i, pose});
      input_.log.push_back(LaserScan{.time = 1.0 * i,
                                     .bearing_step = 0.1,
                                     .max_range = 8.0,
                                     .ranges = std::vector<double>(60, 2.0 + 0.1 * i)});
    }
    for (int i = 0; i + 5 <= 20; i += 5) {
      measured_.relations.push_back({1.0 * i, i + 5.0, {5.0, 0.0, 0.0}});
    }
    input_.relations = [this]() -> const MeasuredRelations& { return measured_; };
    input_.shared = &shared_;
  }
  void put_in(const std::string& option, const std::string& value) {
    const PlannedFaults plan = plan_faults({{"faults." + option, value, {}}});
    input_.clean = input_.log;
    FaultyLog faulty = broken(input_.log, {}, plan, Rng(1));
    input_.log = std::move(faulty.log);
    input_.faults = std::move(faulty.faults);
  }
  std::map<std::string, double> values() const {
    const RunOutcome outcome =
        log_faults_experiment().configure({{"estimator", "odometry", {}}}).make(input_);
    return {outcome.values.begin(), outcome.values.end()};
  }

  RunInput input_;
  MeasuredRelations measured_;
  SharedWork shared_;
};

TEST_F(OdometryInABrokenLog, HasTheErrorOfItsFault) {
  put_in("scale.by", "0.1");  // 5.5 m for 5 m, four times
  const auto values = this->values();
  EXPECT_NEAR(values.at("error"), 0.5, 1e-9);
  EXPECT_NEAR(values.at("odometry_error"), 0.5, 1e-9);
  EXPECT_NEAR(values.at("clean_error"), 0.0, 1e-9);
  EXPECT_EQ(values.at("told"), 0.0);
  EXPECT_EQ(values.at("kept"), 0.0);
  EXPECT_EQ(values.at("kept_or_told"), 0.0);
}

TEST_F(OdometryInABrokenLog, KeepsASmallError) {
  put_in("scale.by", "0.009");  // 4.5 cm in 5 m
  const auto values = this->values();
  EXPECT_NEAR(values.at("error"), 0.045, 1e-9);
  EXPECT_EQ(values.at("kept"), 1.0);
  EXPECT_EQ(values.at("kept_or_told"), 1.0);
}

TEST_F(OdometryInABrokenLog, HasTheCleanErrorWithoutFaults) {
  measured_.relations[0].from_to.x = 6.0;  // one of four a metre off
  const auto values = this->values();
  EXPECT_NEAR(values.at("error"), 0.25, 1e-9);
  EXPECT_EQ(values.at("error"), values.at("clean_error"));
  EXPECT_TRUE(std::isnan(values.at("told")));
  EXPECT_EQ(values.at("error_ratio"), 1.0);
  EXPECT_EQ(values.at("kept_or_told"), 1.0);
  EXPECT_EQ(values.at("alarms"), 0.0);
}

TEST_F(OdometryInABrokenLog, HasTheRatioToTheCleanError) {
  measured_.relations[0].from_to.x = 6.0;
  put_in("scale.by", "0.1");  // 0.5 m the short one, 0.5 m the others
  EXPECT_NEAR(values().at("error_ratio"), 0.5 / 0.25, 1e-9);
}

}  // namespace
}  // namespace mapbed
