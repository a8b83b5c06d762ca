#include "algorithms/scan_matching/matching_diagnostics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::IsEmpty;

constexpr std::optional<double> kByOdometry = {};

ScanMatch fit() {
  return {.trustworthy = true};
}
ScanMatch misfit() {
  return {};
}

TEST(MatchingDiagnostics, SayNothingOfScansThatFit) {
  MatchingDiagnostics diagnostics;
  for (int i = 0; i < 10; ++i) diagnostics.scan(10.0 * i, fit(), true, 0.05);
  EXPECT_THAT(diagnostics.remarks(0.0), IsEmpty());
  EXPECT_THAT(diagnostics.lost(), IsEmpty());
}

// People before the laser.
TEST(MatchingDiagnostics, DoNotTakeTwoScansThatFitNowhereForALostRobot) {
  MatchingDiagnostics diagnostics;
  for (int i = 0; i < 12; ++i) {
    diagnostics.scan(0.2 * i, i % 3 == 0 ? fit() : misfit(), true, kByOdometry);
  }
  EXPECT_THAT(diagnostics.lost(), IsEmpty());
}

TEST(MatchingDiagnostics, KnowThatTheRobotIsLostOnceThreeFitNowhere) {
  MatchingDiagnostics diagnostics;
  diagnostics.scan(1.0, fit(), true, kByOdometry);
  for (const double time : {2.0, 3.0, 4.0, 5.0})
    diagnostics.scan(time, misfit(), true, kByOdometry);
  diagnostics.scan(6.0, fit(), true, kByOdometry);
  ASSERT_EQ(diagnostics.lost().size(), 1U);
  EXPECT_EQ(diagnostics.lost()[0].from, 2.0);
  EXPECT_EQ(diagnostics.lost()[0].to, 5.0);
  EXPECT_THAT(diagnostics.remarks(0.0), ElementsAre(Field(&Remark::kind, RemarkKind::lost)));
}

TEST(MatchingDiagnostics, KnowThatOneIsEnoughAfterAPause) {
  MatchingDiagnostics diagnostics;
  diagnostics.scan(1.0, fit(), true, kByOdometry);
  diagnostics.scan(21.0, misfit(), true, kByOdometry);
  diagnostics.scan(22.0, fit(), true, kByOdometry);
  EXPECT_EQ(diagnostics.lost().size(), 1U);
}

TEST(MatchingDiagnostics, KnowThatTheRobotWasCarriedInAPauseThoughItsScanFits) {
  for (const double pause : {1.0, 20.0}) {
    MatchingDiagnostics diagnostics;
    diagnostics.scan(1.0, fit(), true, kByOdometry);
    ScanMatch elsewhere = fit();
    elsewhere.contradicts_prediction = true;
    diagnostics.scan(1.0 + pause, elsewhere, true, kByOdometry);
    EXPECT_EQ(diagnostics.lost().size(), pause > 10.0 ? 1U : 0U);
  }
}

TEST(MatchingDiagnostics, TellScansThatSeeTooLittle) {
  MatchingDiagnostics diagnostics;
  diagnostics.scan(1.0, misfit(), false, kByOdometry);
  EXPECT_THAT(diagnostics.remarks(0.0), ElementsAre(Field(&Remark::kind, RemarkKind::few_beams)));
}

TEST(MatchingDiagnostics, TellAWayThatNothingMeasures) {
  MatchingDiagnostics diagnostics;
  diagnostics.scan(1.0, fit(), true, 5.0);
  EXPECT_THAT(diagnostics.remarks_on_unknown_motion(0.0),
              ElementsAre(Field(&Remark::kind, RemarkKind::unknown_motion)));
}

}  // namespace
}  // namespace mapbed
