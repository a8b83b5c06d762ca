#include "bench/fetch/corrected_log.h"

#include <gmock/gmock.h>

#include "core/file/text_file.h"
#include "core/log/public_log.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

class CorrectedLog : public ::testing::Test {
 protected:
  std::vector<CorrectedScan> read(const std::string& text) const {
    write_text_file(folder_.file("a.log.gz"), text);
    return read_corrected_log(folder_.file("a.log.gz"));
  }
  TemporaryFolder folder_;
};

// A metre ahead, the filter's correction to another place that looks along y, and a metre ahead
// there: by odometry that makes two metres, along x. The stamp of a correction means nothing.
const char* const kTwoMetres =
    "PARAM robot_frontlaser_offset 0.0 nohost 0\n"
    "ODOM 0 0 0 0 0 0 1 pippo 1\n"
    "ODOM 1 0 0 0 0 0 2 pippo 2\n"
    "FLASER 2 1.50 50 5 5 1.5707963267948966 5 5 1.5707963267948966 2 pippo 2\n"
    "ODOM 5 5 1.5707963267948966 0 0 0 2.4e-91 pippo 2.4e-91\n"
    "NEFF 30\n"
    "ODOM 5 6 1.5707963267948966 0 0 0 3 pippo 3\n"
    "FLASER 2 3 4 5.5 6 1.25 5.5 6 1.25 3.5 pippo 3.5\n";

TEST_F(CorrectedLog, ChainsTheOdometryWithoutTheJumpsOfTheFilter) {
  EXPECT_EQ(
      chained_odometry(read(kTwoMetres), {}),
      "FLASER 2 1.50 50 1.000000 0.000000 0.000000 1.000000 0.000000 0.000000 2.000000 nohost "
      "2.000000\n"
      "FLASER 2 3 4 2.000000 0.000000 0.000000 2.000000 0.000000 0.000000 3.500000 nohost "
      "3.500000\n");
}

TEST_F(CorrectedLog, MovesStampsAndNamesAHost) {
  const MadeFile made{.start = 100.25, .host = "intel"};
  EXPECT_THAT(chained_odometry(read(kTwoMetres), made),
              ::testing::HasSubstr(" 102.250000 intel 2.000000\n"));
}

TEST_F(CorrectedLog, HasThePosesOfTheFilter) {
  EXPECT_EQ(corrected_poses(read(kTwoMetres), {}),
            "2.000000 5.000000 5.000000 1.570796\n3.500000 5.500000 6.000000 1.250000\n");
}

TEST_F(CorrectedLog, AnglesAreWrittenFromMinusPiToPi) {
  const std::string turns =
      "ODOM 0 0 3 0 0 0 1 x 1\nODOM 0 0 -3 0 0 0 2 x 2\n"  // onwards through pi, 2 pi - 6
      "FLASER 1 1 0 0 0 0 0 0 2 x 2\n";
  EXPECT_THAT(chained_odometry(read(turns), {}), ::testing::HasSubstr(" 0.000000 -3.000000 2.0"));
}

TEST_F(CorrectedLog, TellsWhichLineIsNotOfOne) {
  EXPECT_INPUT_ERROR(read("ODOM 0 0 0 0 0 0 1 x 1\nODOM 0 zero 0\n"),
                     "a.log.gz:2: is no line of a corrected log");
  EXPECT_INPUT_ERROR(read("FLASER 3 1 2 3 0 0\n"), "a.log.gz:1: is no line of a corrected log");
  EXPECT_INPUT_ERROR(read("ODOM 0 0 0 0 0 0 1 x 1\n"), "has no FLASER line");
}

}  // namespace
}  // namespace mapbed
