// How far the promise of the same bytes goes: on all processors that multiply and add in one step.
// Without that instruction the C library's sine, exponential and the like round their last digit
// otherwise. It is turned off here as it is missing there.

#include <cstdio>

#include <gmock/gmock.h>

#include "bench/cli/testing/command_test.h"
#include "core/geometry/tum_file.h"
#include "core/log/log_file.h"

namespace mapbed {
namespace {

class FusedArithmetic : public CommandTest {
 protected:
  // Writes with… and without…
  void call_both(const std::string& command, const std::string& suffix = "") const {
    const Outcome with = run_shell("$MAPBED " + command + " --out with" + suffix, path());
    ASSERT_EQ(with.status, 0) << with.err;
    const Outcome without = run_shell("GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4 $MAPBED " +
                                          command + " --out without" + suffix,
                                      path());
    ASSERT_EQ(without.status, 0) << without.err;
  }

  void say_whether_same(const std::string& what, const std::string& file) const {
    const bool same = text("with" + file) == text("without" + file);
    std::printf("without fused multiply-add: %s %s\n", what.c_str(),
                same ? "has the same bytes" : "differs in last digits");
  }
};

// Poses and headings are in the log as they are; readings are rounded to the laser's centimetre,
// which the last digit of a pose can tip.
TEST_F(FusedArithmetic, WithoutItADriveDiffersInLastDigitsOnly) {
  call_both("simulate --world office --robot pioneer --set 'recorder.longest=20 s'", ".log");
  say_whether_same("a simulated log", ".log");
  const RecordedLog with = load_log(path("with.log"));
  const RecordedLog without = load_log(path("without.log"));
  ASSERT_EQ(with.measurements.size(), without.measurements.size());
  long tipped = 0, readings = 0;
  for (std::size_t i = 0; i < with.measurements.size(); ++i) {
    ASSERT_EQ(with.measurements[i].index(), without.measurements[i].index());
    const auto* a = std::get_if<LaserScan>(&with.measurements[i]);
    if (a == nullptr) continue;
    const auto& b = std::get<LaserScan>(without.measurements[i]);
    ASSERT_EQ(a->ranges.size(), b.ranges.size());
    for (std::size_t k = 0; k < a->ranges.size(); ++k, ++readings) {
      EXPECT_NEAR(a->ranges[k], b.ranges[k], 0.0101);
      if (a->ranges[k] != b.ranges[k]) ++tipped;
    }
  }
  EXPECT_LT(tipped, readings / 1000);
  ASSERT_EQ(with.true_poses.size(), without.true_poses.size());
  for (std::size_t i = 0; i < with.true_poses.size(); ++i) {
    EXPECT_LT(distance(with.true_poses[i].pose, without.true_poses[i].pose), 1e-9);
  }
}

TEST_F(FusedArithmetic, WithoutItATrajectoryDiffersInLastDigitsOnly) {
  const Outcome drive = call({"simulate", "--world", "office", "--robot", "pioneer", "--set",
                              "recorder.longest=20 s", "-o", "drive.log"});
  ASSERT_EQ(drive.status, 0) << drive.err;
  for (const std::string method : {"scan_matching", "rbpf"}) {
    call_both("map drive.log --method " + method);
    say_whether_same("the trajectory of " + method, "/trajectory.tum");
    const Trajectory with = load_trajectory(path("with/trajectory.tum"));
    const Trajectory without = load_trajectory(path("without/trajectory.tum"));
    ASSERT_EQ(with.size(), without.size());
    for (std::size_t i = 0; i < with.size(); ++i) {
      EXPECT_LT(distance(with[i].pose, without[i].pose), 1e-6) << method;
    }
  }
}

}  // namespace
}  // namespace mapbed
