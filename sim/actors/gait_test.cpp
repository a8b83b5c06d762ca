#include "sim/actors/gait.h"

#include <cmath>

namespace mapbed {
namespace {

constexpr double kStep = 0.01;  // [s]

TEST(Gait, AStandingFootStaysWhereItIsWhileTheBodyPassesOver) {
  // At foot height the leg is the foot.
  Gait gait({.knee_height = 0.0}, 0.0);
  double body = 0.0;
  for (; body < 5.0; body += 1.2 * kStep) gait.advance(1.2, kStep);  // settles
  std::array<Eigen::Vector2d, 2> before = gait.legs();
  int changes = 0;
  for (int i = 0; i < 200; ++i) {
    gait.advance(1.2, kStep);
    const std::array<Eigen::Vector2d, 2> after = gait.legs();
    const double left = std::abs(after[0].x() - before[0].x() + 1.2 * kStep);
    const double right = std::abs(after[1].x() - before[1].x() + 1.2 * kStep);
    // At least one foot stands; when they change over, neither does for one tick.
    EXPECT_LT(std::min(left, right), 1.2 * kStep + 1e-6);
    changes += std::min(left, right) > 1e-6 ? 1 : 0;
    before = after;
  }
  EXPECT_LE(changes, 200 * 1.2 * kStep / GaitOptions{}.step_length + 1);
}

TEST(Gait, TheFeetComeAStepApart) {
  Gait gait({.step_length = 0.7, .knee_height = 0.0}, 0.0);
  double widest = 0.0;
  for (int i = 0; i < 1000; ++i) {
    gait.advance(1.2, kStep);
    widest = std::max(widest, std::abs(gait.legs()[0].x() - gait.legs()[1].x()));
  }
  EXPECT_NEAR(widest, 0.7, 0.02);
}

TEST(Gait, AtTheKneeTheLegsSwingLess) {
  Gait gait({.step_length = 0.7, .hip_height = 0.9, .knee_height = 0.45}, 0.0);
  double widest = 0.0;
  for (int i = 0; i < 1000; ++i) {
    gait.advance(1.2, kStep);
    widest = std::max(widest, std::abs(gait.legs()[0].x() - gait.legs()[1].x()));
  }
  EXPECT_NEAR(widest, 0.35, 0.01);
}

TEST(Gait, WhoStandsHasBothLegsBesideEachOther) {
  Gait gait({}, 0.3);
  for (int i = 0; i < 500; ++i) gait.advance(1.0, kStep);
  for (int i = 0; i < 500; ++i) gait.advance(0.0, kStep);
  EXPECT_NEAR((gait.legs()[0] - Eigen::Vector2d(0.0, 0.1)).norm(), 0.0, 0.01);
  EXPECT_NEAR((gait.legs()[1] - Eigen::Vector2d(0.0, -0.1)).norm(), 0.0, 0.01);
}

TEST(Gait, NoLegJumps) {
  Gait gait({}, 0.0);
  std::array<Eigen::Vector2d, 2> before = gait.legs();
  for (int i = 0; i < 3000; ++i) {
    gait.advance(0.6 + 0.6 * std::sin(0.01 * i), kStep);
    const std::array<Eigen::Vector2d, 2> after = gait.legs();
    // A swinging foot is up to pi / 2 times twice as fast as the body.
    for (std::size_t leg = 0; leg < 2; ++leg) {
      EXPECT_LT((after[leg] - before[leg]).norm(), 1.2 * kStep * 4.0);
    }
    before = after;
  }
}

}  // namespace
}  // namespace mapbed
