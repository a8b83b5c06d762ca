#include "algorithms/rbpf/input_diagnostics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/testing/remark_texts.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(InputDiagnostics, SayNothingWhereAllIsWell) {
  InputDiagnostics diagnostics{InputDiagnosticsOptions{}};
  for (int i = 0; i < 20; ++i) {
    const Odometry odometry{.time = 100.0 + i, .odometry_from_robot = {0.5 * i, 0.0, 0.0}};
    diagnostics.odometry(odometry);
    diagnostics.scan(odometry.time, Pose2{0.5, 0.0, 0.0}, true);
    diagnostics.update(odometry.time, 0.8);
  }
  EXPECT_THAT(texts_of(diagnostics.remarks()), IsEmpty());
}

TEST(InputDiagnostics, MotionThatOdometryDoesNotKnowInterruptsUntilTheNextUpdate) {
  InputDiagnostics diagnostics{InputDiagnosticsOptions{}};
  diagnostics.odometry({.time = 10.0});
  EXPECT_FALSE(diagnostics.interruption());
  diagnostics.odometry({.time = 10.5, .motion_unknown = true});
  diagnostics.odometry({.time = 11.0});
  EXPECT_EQ(diagnostics.interruption(), 10.5);
  diagnostics.update(11.0, 0.8);
  EXPECT_FALSE(diagnostics.interruption());
}

TEST(InputDiagnostics, AScanThatDoesNotFitAfterAPauseInterruptsAndOneAmongOthersDoesNot) {
  InputDiagnostics diagnostics{InputDiagnosticsOptions{}};
  diagnostics.scan(0.0, Pose2{}, true);
  diagnostics.scan(1.0, Pose2{}, true, false);
  EXPECT_FALSE(diagnostics.interruption());
  diagnostics.scan(21.0, Pose2{}, true, true);
  EXPECT_FALSE(diagnostics.interruption());
  diagnostics.scan(41.0, Pose2{}, true, false);
  EXPECT_EQ(diagnostics.interruption(), 41.0);
}

TEST(InputDiagnostics, TheRobotIsLostFromTheInterruptionOnNotFromTheUpdateThatShowsIt) {
  InputDiagnostics diagnostics{InputDiagnosticsOptions{}};
  diagnostics.scan(0.0, Pose2{}, true);
  diagnostics.update(0.0, 0.8);
  diagnostics.scan(20.0, Pose2{}, true, false);
  diagnostics.scan(23.0, Pose2{}, true);
  diagnostics.update(23.0, 0.8, false);
  diagnostics.update(24.0, 0.8);
  EXPECT_THAT(texts_of(diagnostics.remarks()),
              ElementsAre(HasSubstr("lost from 20.0 s to 23.0 s")));
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
    diagnostics.odometry({.time = 100.0 + i});
    diagnostics.scan(100.0 + i, Pose2{}, i != 7);
  }
  const std::vector<Remark> remarks = diagnostics.remarks();
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_EQ(remarks[0].kind, RemarkKind::blind_laser);
  EXPECT_EQ(remarks[0].when, (TimeInterval{107.0, 107.0}));
}

TEST(InputDiagnostics, ManyOfOneKindAreSummedUp) {
  InputDiagnostics diagnostics{InputDiagnosticsOptions{}};
  for (int i = 0; i < 20; ++i) diagnostics.scan(i, Pose2{}, i % 2 == 0);
  EXPECT_EQ(diagnostics.remarks().size(), 4U);
  EXPECT_THAT(diagnostics.remarks().back().text, HasSubstr("10 times in all"));
}

}  // namespace
}  // namespace mapbed
