#include "sim/relations.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

using ::testing::DoubleNear;
using ::testing::Pointwise;

using Rows = std::vector<std::vector<double>>;

Rows rows_of(const std::string& text) {
  Rows rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    rows.emplace_back();
    for (double value = 0.0; fields >> value;) rows.back().push_back(value);
  }
  return rows;
}

void expect_rows(const Rows& found, const Rows& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_THAT(found[i], Pointwise(DoubleNear(1e-6), expected[i])) << "row " << i;
  }
}

// t1 t2, then the second pose in the frame of the first: x y z roll pitch yaw.
TEST(Relations, AreTheMotionsBetweenPosesOfThePath) {
  const Trajectory path{{10.0, {1.0, 1.0, 0.0}},
                        {12.0, {3.0, 2.0, kPi / 2}},     // 2 m ahead, 1 m to the left, turned
                        {15.0, {2.0, 2.5, -3.0}},        // 0.5 m ahead, 1 m to the left
                        {17.0, {2.0, 2.5 + 1.5, 3.0}}};  // across the wrap of the heading
  const double c = std::cos(-3.0), s = std::sin(-3.0);
  expect_rows(rows_of(relations_text(path)), {{10, 12, 2, 1, 0, 0, 0, kPi / 2},
                                              {12, 15, 0.5, 1, 0, 0, 0, 2 * kPi - 3.0 - kPi / 2},
                                              {15, 17, s * 1.5, c * 1.5, 0, 0, 0, 6.0 - 2 * kPi}});
}

TEST(Relations, PassOverPosesThatAreNearerThanTheShortest) {
  Trajectory path;
  for (int i = 0; i <= 7; ++i) path.push_back({0.1 * i, {0.4 * i, 0.0, 0.0}});
  // After 1 m or more: at 1.2 m and 2.4 m.
  expect_rows(rows_of(relations_text(path)),
              {{0.0, 0.3, 1.2, 0, 0, 0, 0, 0}, {0.3, 0.6, 1.2, 0, 0, 0, 0, 0}});
}

// A square of 3 m: back at its beginning, after a way of 11.9 m, 0.1 m from the first pose.
TEST(Relations, ReachBackToThePlaceBeforeALoop) {
  const Trajectory path{{0, {0, 0, 0}},
                        {1, {3, 0, kPi / 2}},
                        {2, {3, 3, kPi}},
                        {3, {0, 3, -kPi / 2}},
                        {4, {0, 0.1, -kPi / 2}}};
  const Rows around = {{0, 1, 3, 0, 0, 0, 0, kPi / 2},
                       {1, 2, 3, 0, 0, 0, 0, kPi / 2},
                       {2, 3, 3, 0, 0, 0, 0, kPi / 2},
                       {3, 4, 2.9, 0, 0, 0, 0, 0}};
  Rows closed = around;
  closed.push_back({0, 4, 0, 0.1, 0, 0, 0, -kPi / 2});
  expect_rows(rows_of(relations_text(path, {.shortest = 1.0, .longest = 11.8})), closed);
  expect_rows(rows_of(relations_text(path, {.shortest = 1.0, .longest = 12.0})), around);
}

// Back beside the second pose of the way: the first one is within the 2 m of a place, too.
TEST(Relations, ReachBackToTheNearestPoseOfBefore) {
  const Trajectory path{{0, {0, 0, 0}}, {1, {1.5, 0, 0}}, {2, {8, 0, 0}}, {3, {1.4, 0, 0}}};
  const Rows rows = rows_of(relations_text(path, {.shortest = 1.0, .longest = 10.0}));
  expect_rows(rows, {{0, 1, 1.5, 0, 0, 0, 0, 0},
                     {1, 2, 6.5, 0, 0, 0, 0, 0},
                     {2, 3, -6.6, 0, 0, 0, 0, 0},
                     {1, 3, -0.1, 0, 0, 0, 0, 0}});
}

}  // namespace
}  // namespace mapbed
