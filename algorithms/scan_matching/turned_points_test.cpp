#include "algorithms/scan_matching/turned_points.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace mapbed {
namespace {

class PointsAboutARobot : public ::testing::Test {
 protected:
  PointsAboutARobot() {
    Rng rng(7);
    for (int i = 0; i < 101; ++i) {  // no multiple of what processors take at a time
      points_.x.push_back(static_cast<float>(rng.uniform(-60, 60)));
      points_.y.push_back(static_cast<float>(rng.uniform(-60, 60)));
      field_.add(SurfacePoint{{rng.uniform(-3, 3), rng.uniform(-3, 3)}});
    }
    pyramid_ = make_bound_pyramid(field_, 3.0);
  }

  TurnedPoints turned(const TurnGroup& group, Processor processor) const {
    return PointTurner(points_, kRobot, field_.resolution(), pyramid_, kLattice, 2, processor)
        .turned(group);
  }

  static constexpr Pose2 kRobot{0.42, -0.87, 3.0};
  static constexpr SearchLattice kLattice{.shifts = 60, .turns = 40, .turn_step = 0.013};
  FieldPoints points_;
  LikelihoodField field_;
  BoundPyramid pyramid_;
};

TEST_F(PointsAboutARobot, FallIntoTheSameCellsOnEachProcessor) {
  if (this_processor() == Processor::any) GTEST_SKIP() << "this machine has but one";
  for (const TurnGroup group : {TurnGroup{-40, 0, 2}, {7, 0, 3}, {-8, 1, 3}, {4, 2, 4}}) {
    const TurnedPoints plain = turned(group, Processor::any);
    const TurnedPoints wide = turned(group, Processor::avx2);
    EXPECT_EQ(wide.cells.x, plain.cells.x);
    EXPECT_EQ(wide.cells.y, plain.cells.y);
    EXPECT_EQ(wide.cells.level, plain.cells.level);
  }
}

// From the first cell on up to what the level covers, at each of the group's turns.
TEST_F(PointsAboutARobot, LieWithinWhatTheirLevelsCover) {
  const TurnGroup group{-8, 2, 4};
  const TurnedPoints turned = this->turned(group, this_processor());
  ASSERT_EQ(turned.cells.size(), points_.size());
  for (int turn = group.first; turn < group.first + 4; ++turn) {
    const Pose2 pose = kLattice.pose(kRobot, field_.resolution(), turn, 0, 0);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Eigen::Vector2d at =
          pose *
          (field_.resolution() * Eigen::Vector2d(double{points_.x[i]}, double{points_.y[i]})) /
          field_.resolution();
      if (turned.cells.level[i] == PointsInCells::kUnbounded) continue;
      // Without the block's own shifts of up to 2^4 - 1 cells.
      const int covered = (1 << turned.cells.level[i]) - (1 << group.level) + 1;
      EXPECT_GE(at.x(), turned.cells.x[i] - 1e-9);
      EXPECT_LT(at.x(), turned.cells.x[i] + covered + 1e-9);
      EXPECT_GE(at.y(), turned.cells.y[i] - 1e-9);
      EXPECT_LT(at.y(), turned.cells.y[i] + covered + 1e-9);
    }
  }
}

}  // namespace
}  // namespace mapbed
