#include "algorithms/people/front_end/occlusion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/people/testing/people_in_a_room.h"

namespace mapbed {
namespace {

ScanView view_behind_a_wall() {
  TestRoom room = rectangular_room(12.0, 10.0);
  room.add({{2.0, -1.0}, {2.0, 1.0}});
  return ScanView(scan_of(room, {}, round_laser()));
}

TEST(Occlusion, HidesWhatIsBehindSomething) {
  const ScanView view = view_behind_a_wall();
  EXPECT_EQ(hidden_probability(view, {4.0, 0.0}, 0.15), 1.0);
  EXPECT_EQ(hidden_probability(view, {1.0, 0.0}, 0.15), 0.0);
  EXPECT_EQ(hidden_probability(view, {2.0, 4.0}, 0.15), 0.0);
}

TEST(Occlusion, IsPartialAtAnEdge) {
  // The edge at (2, 1) is seen at atan(1/2); at 4 m the shadow begins on the line to (4, 2).
  const double hidden = hidden_probability(view_behind_a_wall(), {4.0, 2.0}, 0.2);
  EXPECT_NEAR(hidden, 0.5, 0.15);
}

TEST(Occlusion, IsWholeOutsideOfTheViewAndBeyondTheRange) {
  const ScanView view = view_behind_a_wall();
  EXPECT_EQ(hidden_probability(view, {-3.0, 0.0}, 0.15), 1.0);
  EXPECT_EQ(hidden_probability(view, {0.0, 40.0}, 0.15), 1.0);
}

TEST(Occlusion, GridIsTheSameCellByCell) {
  const ScanView view = view_behind_a_wall();
  const OcclusionGrid grid = occlusion_grid(view, 5.0, 0.5, 0.15);
  ASSERT_EQ(grid.cells, 20);
  EXPECT_EQ(grid.at(18, 10), hidden_probability(view, {4.25, 0.25}, 0.15));
  EXPECT_EQ(grid.at(12, 10), hidden_probability(view, {1.25, 0.25}, 0.15));
  EXPECT_EQ(grid.at(18, 10), 1.0);
}

}  // namespace
}  // namespace mapbed
