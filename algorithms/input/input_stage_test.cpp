#include "algorithms/input/input_stage.h"

#include <gtest/gtest.h>

#include "core/testing/test_room.h"

namespace mapbed {
namespace {

RecordedLog room_drive() {
  return drive_through(rectangular_room(6.0, 4.0), {{-1.0, 0.0}, {1.5, 0.5}}, {}, Rng(1));
}

bool are_same(const Measurement& a, const Measurement& b) {
  if (a.index() != b.index() || time_of(a) != time_of(b)) return false;
  if (const auto* odometry = std::get_if<Odometry>(&a)) {
    return odometry->odometry_from_robot == std::get<Odometry>(b).odometry_from_robot;
  }
  return std::get<LaserScan>(a).ranges == std::get<LaserScan>(b).ranges;
}

TEST(InputStage, DoesNotChangeWhatIsInOrder) {
  const SensorLog log = room_drive().measurements;
  const PreparedLog ready = prepared(log);
  ASSERT_EQ(ready.log.size(), log.size());
  for (std::size_t i = 0; i < log.size(); ++i) EXPECT_TRUE(are_same(ready.log[i], log[i])) << i;
  EXPECT_TRUE(ready.remarks.empty());
}

TEST(InputStage, TakesAnEmptyLog) {
  EXPECT_TRUE(prepared({}).log.empty());
}

}  // namespace
}  // namespace mapbed
