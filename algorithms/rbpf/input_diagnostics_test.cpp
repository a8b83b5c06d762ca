#include "algorithms/rbpf/input_diagnostics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/testing/remark_texts.h"
#include "core/testing/is_near.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(InputDiagnostics, SayNothingWhereAllIsWell) {
  InputDiagnostics diagnostics{InputDiagnosticsOptions{}};
  for (int i = 0; i < 20; ++i) {
    const Odometry odometry{.time = 100.0 + i, .odometry_from_robot = {0.5 * i, 0.0, 0.0}};
    EXPECT_THAT(diagnostics.without_jumps(odometry).odometry_from_robot,
                IsNear(odometry.odometry_from_robot, Tolerance{1e-9, 1e-9}));
    diagnostics.scan(odometry.time, Pose2{0.5, 0.0, 0.0}, true);
    diagnostics.update(odometry.time, 0.8);
  }
  EXPECT_THAT(texts_of(diagnostics.remarks()), IsEmpty());
}

TEST(InputDiagnostics, AJumpOfOdometryIsTakenOutAndTold) {
  InputDiagnostics diagnostics{InputDiagnosticsOptions{}};
  Pose2 passed;
  for (int i = 0; i < 10; ++i) {
    const double jump = i < 5 ? 0.0 : 7.0;
    passed =
        diagnostics
            .without_jumps({.time = 10.0 + 0.1 * i, .odometry_from_robot = {0.05 * i, jump, 0.0}})
            .odometry_from_robot;
  }
  // The step with the jump counts as standing still.
  EXPECT_THAT(passed, IsNear(Pose2{8 * 0.05, 0.0, 0.0}, Tolerance{1e-9, 1e-9}));
  EXPECT_THAT(texts_of(diagnostics.remarks()),
              ElementsAre("odometry jumps from 0.5 s to 0.5 s after the start (by up to 7.0 m): "
                          "taken as standing still"));
}

// Of steps of odometry of half a second each.
bool jumps(const Pose2& step, const InputDiagnosticsOptions& options, double seconds = 0.5) {
  InputDiagnostics diagnostics(options);
  diagnostics.without_jumps({.time = 0.0});
  diagnostics.without_jumps({.time = seconds, .odometry_from_robot = step});
  return !diagnostics.remarks().empty();
}

TEST(InputDiagnostics, OdometryThatIsTooFastHasJumped) {
  EXPECT_FALSE(jumps({0.9, 0.0, 0.0}, {.max_speed = 2.0}));
  EXPECT_TRUE(jumps({0.8, 0.8, 0.0}, {.max_speed = 2.0}));
}

TEST(InputDiagnostics, OdometryThatTurnsTooFastHasJumped) {
  EXPECT_FALSE(jumps({0.0, 0.0, -0.9}, {.max_turn_rate = 2.0}));
  EXPECT_TRUE(jumps({0.0, 0.0, -1.1}, {.max_turn_rate = 2.0}));
}

// Stamps may be off, as where a driver hands out readings in bunches.
TEST(InputDiagnostics, ReadingsWithNearlyTheSameStampHaveNotJumped) {
  EXPECT_FALSE(jumps({0.2, 0.0, 0.1}, {.max_speed = 1.0, .max_turn_rate = 1.0}, 0.001));
}

TEST(InputDiagnostics, TheFirstScanHasNoStepAndMissesNone) {
  InputDiagnostics diagnostics{InputDiagnosticsOptions{}};
  diagnostics.scan(0.0, {}, true);
  diagnostics.scan(1.0, Pose2{}, true);
  EXPECT_THAT(texts_of(diagnostics.remarks()), IsEmpty());
}

TEST(InputDiagnostics, TellWhenOdometryWasMissing) {
  InputDiagnostics diagnostics{InputDiagnosticsOptions{}};
  for (int i = 0; i < 10; ++i) {
    const bool missing = i >= 3 && i <= 6;
    diagnostics.scan(5.0 + i, missing ? std::optional<Pose2>{} : Pose2{}, true);
  }
  EXPECT_THAT(texts_of(diagnostics.remarks()),
              ElementsAre(HasSubstr("no odometry from 3.0 s to 6.0 s after the start")));
}

TEST(InputDiagnostics, TellOfAPauseInWhichTheRobotWentOnAndOfNoOther) {
  InputDiagnostics diagnostics{InputDiagnosticsOptions{}};
  diagnostics.scan(0.0, Pose2{}, true);
  diagnostics.scan(12.0, Pose2{0.2, 0.0, 0.0}, true);  // stood
  EXPECT_THAT(texts_of(diagnostics.remarks()), IsEmpty());
  diagnostics.scan(24.0, Pose2{6.0, 0.0, 0.0}, true);
  EXPECT_THAT(texts_of(diagnostics.remarks()),
              ElementsAre(HasSubstr("no scan from 12.0 s to 24.0 s after the start")));
}

TEST(InputDiagnostics, TellOfAPauseInWhichTheRobotTurned) {
  for (const double turn : {-2.0, 2.0}) {
    InputDiagnostics diagnostics{InputDiagnosticsOptions{}};
    diagnostics.scan(0.0, Pose2{}, true);
    diagnostics.scan(12.0, Pose2{0.0, 0.0, turn}, true);
    EXPECT_THAT(texts_of(diagnostics.remarks()),
                ElementsAre(HasSubstr("no scan from 0.0 s to 12.0 s")));
  }
}

TEST(InputDiagnostics, TellOfALaserThatSeesNothing) {
  InputDiagnostics diagnostics{InputDiagnosticsOptions{}};
  for (int i = 0; i < 4; ++i) diagnostics.scan(i, Pose2{}, i == 0);
  EXPECT_THAT(texts_of(diagnostics.remarks()),
              ElementsAre(HasSubstr("sees nothing from 1.0 s to 3.0 s")));
}

TEST(InputDiagnostics, TellOfALaserThatSeesNothingWhereOdometryIsMissingToo) {
  InputDiagnostics diagnostics{InputDiagnosticsOptions{}};
  for (int i = 0; i < 4; ++i) diagnostics.scan(i, {}, i == 0);
  EXPECT_THAT(texts_of(diagnostics.remarks()),
              ElementsAre(HasSubstr("neither odometry nor anything that the laser sees from 1.0 s "
                                    "to 3.0 s after the start: how the robot moved is not known")));
}

TEST(InputDiagnostics, ARobotIsLostWhereTheMapExplainsNextToNothing) {
  InputDiagnostics diagnostics({.lost_below = 0.25});
  const double inlier_ratio[] = {0.9, 0.6, 0.1, 0.2, 0.7, 0.8};
  for (int i = 0; i < 6; ++i) {
    diagnostics.scan(i, Pose2{}, true);
    diagnostics.update(i, inlier_ratio[i]);
  }
  EXPECT_THAT(texts_of(diagnostics.remarks()), ElementsAre(HasSubstr("lost from 2.0 s to 3.0 s")));
}

TEST(InputDiagnostics, RemarksHaveTheirKindAndTheStampsOfTheLog) {
  InputDiagnostics diagnostics{InputDiagnosticsOptions{}};
  for (int i = 0; i < 10; ++i) {
    diagnostics.without_jumps({.time = 100.0 + i, .odometry_from_robot = {i < 4 ? 0.0 : 50.0}});
    diagnostics.scan(100.0 + i, Pose2{}, i != 7);
  }
  const std::vector<Remark> remarks = diagnostics.remarks();
  ASSERT_EQ(remarks.size(), 2U);
  EXPECT_EQ(remarks[0].kind, RemarkKind::odometry_jump);
  EXPECT_EQ(remarks[0].when, (TimeInterval{104.0, 104.0}));
  EXPECT_EQ(remarks[1].kind, RemarkKind::blind_laser);
  EXPECT_EQ(remarks[1].when, (TimeInterval{107.0, 107.0}));
}

TEST(InputDiagnostics, ManyOfOneKindAreSummedUp) {
  InputDiagnostics diagnostics{InputDiagnosticsOptions{}};
  for (int i = 0; i < 20; ++i) diagnostics.scan(i, Pose2{}, i % 2 == 0);
  EXPECT_EQ(diagnostics.remarks().size(), 4U);
  EXPECT_THAT(diagnostics.remarks().back().text, HasSubstr("10 times in all"));
}

}  // namespace
}  // namespace mapbed
