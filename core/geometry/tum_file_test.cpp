#include "core/geometry/tum_file.h"

#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/file/text_file.h"
#include "core/geometry/angle.h"
#include "core/input_error.h"
#include "core/testing/is_near.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;

std::string message_of(const std::string& text) {
  try {
    parse_trajectory("t.tum", text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

const Trajectory kPath = {{976052857.348896, {1.25, -3.5, 0.1}},
                          {976052857.348897, {1e3, 2e-6, -3.1}},
                          {976052858.0, {0, 0, kPi}}};

TEST(TumFile, ReadsWhatItWroteToTheLastPrintedDigit) {
  const Trajectory read = parse_trajectory("t", tum_text(kPath));
  ASSERT_EQ(read.size(), kPath.size());
  for (std::size_t i = 0; i < kPath.size(); ++i) {
    EXPECT_NEAR(read[i].time, kPath[i].time, 2e-7);  // a double at 1e9 s steps by 1.2e-7 s
    EXPECT_THAT(read[i].pose, IsNear(kPath[i].pose, Tolerance{1e-9, 3e-9}));
  }
  EXPECT_EQ(tum_text(read), tum_text(kPath));
}

TEST(TumFile, WritesStampsToTheMicrosecond) {
  EXPECT_THAT(tum_text(kPath), HasSubstr("976052857.348896 1.250000000 -3.500000000 0 0 0 "));
}

TEST(TumFile, PackedFilesReadAlike) {
  const std::string path = ::testing::TempDir() + "trajectory.tum.gz";
  write_trajectory(path, kPath);
  EXPECT_EQ(read_text_file(path), tum_text(kPath));
  EXPECT_EQ(load_trajectory(path).size(), 3u);
}

TEST(TumFile, ReadsLinesOfTimePositionAndHeadingToo) {
  const Trajectory read =
      parse_trajectory("t", "# t x y theta\n\n5.5 1 2 0.3\r\n6 1 2 7 # turned\n");
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].time, 5.5);
  EXPECT_THAT(read[0].pose, IsNear(Pose2{1, 2, 0.3}, Tolerance{0, 0}));
  EXPECT_NEAR(read[1].pose.theta, 7 - 2 * kPi, 1e-12);
}

TEST(TumFile, KeepsTheHeadingOfAPoseInSpace) {
  // Heading 90 deg, then pitched by 60 deg about the new y axis: q = z(90) * y(60).
  const double c = std::cos(kPi / 6) * std::sqrt(0.5);
  const double s = std::sin(kPi / 6) * std::sqrt(0.5);
  const std::string line = fmt::format("1 0 0 0 {} {} {} {}", -s, s, c, c);
  EXPECT_NEAR(parse_trajectory("t", line)[0].pose.theta, kPi / 2, 1e-5);
}

TEST(TumFile, KeepsTheHeadingOfAPoseThatIsRolled) {
  // Heading 30 deg, then rolled by 60 deg about the new x axis: q = z(30) * x(60).
  const double cz = std::cos(kPi / 12), sz = std::sin(kPi / 12);
  const double cx = std::cos(kPi / 6), sx = std::sin(kPi / 6);
  const std::string line = fmt::format("1 0 0 0 {} {} {} {}", cz * sx, sz * sx, sz * cx, cz * cx);
  EXPECT_NEAR(parse_trajectory("t", line)[0].pose.theta, kPi / 6, 1e-5);
}

TEST(TumFile, PutsPosesInOrderOfTimeAndKeepsTheOrderOfEqualStamps) {
  const Trajectory poses = parse_trajectory("t", "2 20 0 0\n1 10 0 0\n2 21 0 0\n");
  ASSERT_EQ(poses.size(), 3U);
  EXPECT_EQ(poses[0].pose.x, 10);
  EXPECT_EQ(poses[1].pose.x, 20);
  EXPECT_EQ(poses[2].pose.x, 21);
}

TEST(TumFile, RefusesWrongLinesByNumber) {
  EXPECT_EQ(message_of("1 0 0 0\n2 0 zero 0\n"),
            "t.tum:2: 'zero' is not a number; lines are `t x y z qx qy qz qw` or `t x y theta`");
  EXPECT_EQ(message_of("1 0 0\n"),
            "t.tum:1: has 3 numbers; lines are `t x y z qx qy qz qw` or `t x y theta`");
  EXPECT_EQ(message_of("1 0 0 nan\n"),
            "t.tum:1: 'nan' is not a number; lines are `t x y z qx qy qz qw` or `t x y theta`");
  EXPECT_EQ(message_of("1 0 0 0 0 0 0 2\n"),
            "t.tum:1: the quaternion has length 2, not 1; its order is qx qy qz qw");
  EXPECT_EQ(message_of("# nothing\n"),
            "t.tum: holds no pose; lines are `t x y z qx qy qz qw` or `t x y theta`");
}

}  // namespace
}  // namespace mapbed
