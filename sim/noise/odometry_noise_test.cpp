#include "sim/noise/odometry_noise.h"

#include <cmath>
#include <functional>

#include "core/geometry/angle.h"
#include "core/statistics/moments.h"
#include "core/testing/is_near.h"

namespace mapbed {
namespace {

std::vector<Odometry> with_noise(const std::vector<IdealOdometry>& ideal,
                                 const OdometryModel& model, const Rng& rng) {
  OdometryReader reader(model, rng);
  std::vector<Odometry> readings;
  for (const IdealOdometry& reading : ideal) readings.push_back(reader.read(reading));
  return readings;
}

constexpr int kSteps = 20'000;

std::vector<IdealOdometry> same_step(const Pose2& step) {
  std::vector<IdealOdometry> drive(1);
  for (int k = 1; k <= kSteps; ++k) {
    IdealOdometry next = drive.back();
    next.time = 0.1 * k;
    next.truth = next.truth * step;
    next.wheels = next.truth;
    drive.push_back(next);
  }
  return drive;
}

// Over all steps, of something measured on a step's noisy motion.
Moments moments(const Pose2& step, const OdometryModel& model,
                const std::function<double(const Pose2&)>& measure) {
  const std::vector<Odometry> noisy = with_noise(same_step(step), model, Rng(7));
  Moments result;
  for (std::size_t k = 1; k < noisy.size(); ++k) {
    result.add(
        measure(motion_between(noisy[k - 1].odometry_from_robot, noisy[k].odometry_from_robot)));
  }
  return result;
}

// Five standard errors, and rounding.
void expect_moments(const Moments& found, double mean, double sigma) {
  EXPECT_NEAR(found.mean(), mean, 5 * sigma / std::sqrt(kSteps) + 1e-9);
  EXPECT_NEAR(found.sigma(), sigma, 5 * sigma / std::sqrt(2.0 * kSteps) + 1e-9);
}

double turn(const Pose2& motion) {
  return motion.theta;
}
double way(const Pose2& motion) {
  return std::hypot(motion.x, motion.y);
}
double direction(const Pose2& motion) {
  return std::atan2(motion.y, motion.x);
}

TEST(OdometryNoise, WithoutErrorsReadsTheMotionFromTheIdentityOn) {
  std::vector<IdealOdometry> drive(2);
  drive[0].truth = {3.0, 4.0, 1.0};
  drive[1].truth = drive[0].truth * Pose2{0.5, 0.1, 0.2};
  drive[1].wheels = {0.6, 0.0, 0.1};
  OdometryModel model;
  const Tolerance exact{1e-12, 1e-12};

  EXPECT_THAT(with_noise(drive, model, Rng(1))[0].odometry_from_robot, IsNear(Pose2{}, exact));
  EXPECT_THAT(with_noise(drive, model, Rng(1))[1].odometry_from_robot,
              IsNear(drive[1].wheels, exact));
  model.source = OdometrySource::truth;
  EXPECT_THAT(with_noise(drive, model, Rng(1))[1].odometry_from_robot,
              IsNear(Pose2{0.5, 0.1, 0.2}, exact));
}

TEST(OdometryNoise, TheDistanceErrorGrowsWithTheRootOfTheWay) {
  const OdometryModel model{.distance_bias = 0.02, .distance_per_meter = 0.01};
  expect_moments(moments({0.25, 0.0, 0.0}, model, way), 0.25 * 1.02, 0.01 * std::sqrt(0.25));
}

TEST(OdometryNoise, TheStartTurnBendsTheWay) {
  const OdometryModel model{.start_turn_bias = 0.04, .start_turn_per_meter = 0.02};
  expect_moments(moments({0.25, 0.0, 0.0}, model, direction), 0.01, 0.02 * std::sqrt(0.25));
}

TEST(OdometryNoise, TheEndTurnErrsWithWayAndTurn) {
  const OdometryModel model{
      .end_turn_bias = 0.1, .end_turn_per_meter = 0.03, .end_turn_per_radian = 0.04};
  const double sigma = std::sqrt(0.03 * 0.03 * 0.25 + 0.04 * 0.04 * 0.2);
  expect_moments(moments({0.25, 0.0, 0.2}, model, turn), 0.22, sigma);
  expect_moments(moments({0.25, 0.0, -0.2}, model, turn), -0.22, sigma);  // too far to both sides
}

TEST(OdometryNoise, BackingUpKeepsItsDirection) {
  const OdometryModel model{.start_turn_per_meter = 0.02};
  const auto direction_back = [](const Pose2& m) { return std::atan2(-m.y, -m.x); };
  expect_moments(moments({-0.25, 0.0, 0.0}, model, direction_back), 0.0, 0.02 * 0.5);
}

TEST(OdometryNoise, ComponentsErrEachByTheirOwnWay) {
  const OdometryModel model{.errors = OdometryErrors::components,
                            .distance_bias = 0.02,
                            .distance_per_meter = 0.01,
                            .end_turn_bias = 0.1,
                            .end_turn_per_meter = 0.03,
                            .end_turn_per_radian = 0.04,
                            .sideways_bias = -0.05,
                            .sideways_per_meter = 0.04};
  const auto x = [](const Pose2& m) { return m.x; };
  const auto y = [](const Pose2& m) { return m.y; };
  const Pose2 step{0.04, -0.09, 0.2};  // sideways to the right, mostly
  expect_moments(moments(step, model, x), 0.04 * 1.02, 0.01 * 0.2);
  expect_moments(moments(step, model, y), -0.09 * 0.95, 0.04 * 0.3);
  const double sigma = std::sqrt(0.03 * 0.03 * std::hypot(0.04, 0.09) + 0.04 * 0.04 * 0.2);
  expect_moments(moments(step, model, turn), 0.22, sigma);
}

TEST(OdometryNoise, TheAddedNoiseIsThatOfEveryReading) {
  const OdometryModel model{.translation_sigma = 0.03, .rotation_sigma = radians(2.0)};
  const auto x = [](const Pose2& m) { return m.x; };
  const auto y = [](const Pose2& m) { return m.y; };
  expect_moments(moments({0.1, 0.0, 0.05}, model, x), 0.1, 0.03);
  expect_moments(moments({0.1, 0.0, 0.05}, model, y), 0.0, 0.03);
  expect_moments(moments({0.1, 0.0, 0.05}, model, turn), 0.05, radians(2.0));
}

TEST(OdometryNoise, StandingStillAddsNothingByItself) {
  const OdometryModel model{.distance_per_meter = 0.1, .end_turn_per_radian = 0.1};
  const std::vector<Odometry> noisy = with_noise(same_step({}), model, Rng(7));
  EXPECT_THAT(noisy.back().odometry_from_robot, IsNear(Pose2{}, Tolerance{1e-12, 1e-12}));
}

}  // namespace
}  // namespace mapbed
