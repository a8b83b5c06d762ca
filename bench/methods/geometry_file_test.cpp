#include "bench/methods/geometry_file.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace mapbed {
namespace {

TEST(GeometryFile, TellsEachLaserByItsFirstScan) {
  LaserScan front{.time = 1.0, .first_bearing = -1.5, .bearing_step = 0.5, .max_range = 8.0};
  front.robot_from_laser = {{0.1, 0.2, 0.3}, 0.4, 0.0, 0.0};
  front.ranges = {1.0, 2.0, 3.0};
  LaserScan rear = front;
  rear.laser = 1;
  rear.ranges = {1.0};
  LaserScan later = front;
  later.ranges = {1.0, 2.0};

  const auto json = nlohmann::json::parse(geometry_json({Odometry{}, front, rear, later}));
  ASSERT_EQ(json["lasers"].size(), 2u);
  EXPECT_EQ(json["lasers"][0]["beams"], 3);
  EXPECT_EQ(json["lasers"][0]["first_bearing"], -1.5);
  EXPECT_EQ(json["lasers"][0]["z"], 0.4);
  EXPECT_EQ(json["lasers"][1]["laser"], 1);
  EXPECT_EQ(json["lasers"][1]["beams"], 1);
}

}  // namespace
}  // namespace mapbed
