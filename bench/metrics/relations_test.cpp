#include "bench/metrics/relations.h"

#include <cmath>
#include <fstream>

#include <gmock/gmock.h>

#include "core/geometry/angle.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;

constexpr double kRounding = 1e-12;

// Straight ahead at 1 m/s from t = 0 to t = 10, a pose every 10 s.
Trajectory straight() {
  return {{0.0, {0, 0, 0}}, {10.0, {10, 0, 0}}};
}

TEST(Relations, OfTheEstimateItselfHaveNoError) {
  const RelationsError error = relations_error(straight(), {{2.0, 5.0, {3, 0, 0}}});
  EXPECT_EQ(error.count, 1);
  EXPECT_NEAR(error.mean_translation, 0.0, kRounding);
  EXPECT_NEAR(error.mean_rotation, 0.0, kRounding);
}

TEST(Relations, MeanAndSigmaAreThoseOfTheLengths) {
  // Errors of 3-4-5 and of 1 m: mean 3 m, sigma 2 m; turns of 0.1 and -0.3: mean 0.2 rad.
  const std::vector<Relation> relations{{0.0, 10.0, {10 - 3, -4, 0.1}},
                                        {0.0, 10.0, {10 - 1, 0, -0.3}}};
  const RelationsError error = relations_error(straight(), relations);
  EXPECT_NEAR(error.mean_translation, 3.0, kRounding);
  EXPECT_NEAR(error.sigma_translation, 2.0, kRounding);
  EXPECT_NEAR(error.mean_rotation, 0.2, kRounding);
}

TEST(Relations, AStampMayComeBeforeTheOther) {
  const RelationsError error = relations_error(straight(), {{5.0, 2.0, {-3, 0, 0}}});
  EXPECT_NEAR(error.mean_translation, 0.0, kRounding);
}

TEST(Relations, SkipsAndCountsStampsMoreThanFiveSecondsOutside) {
  const RelationsError error =
      relations_error(straight(), {{-5.1, 5.0, {}}, {5.0, 15.1, {}}, {-4.9, 14.9, {10, 0, 0}}});
  EXPECT_EQ(error.count, 1);
  EXPECT_EQ(error.skipped, 2);
  EXPECT_NEAR(error.mean_translation, 0.0, kRounding) << "the outermost poses are held";
}

TEST(Relations, NothingToCompareIsNotANumberAndNotZero) {
  const RelationsError error = relations_error(straight(), {{100.0, 200.0, {}}});
  EXPECT_EQ(error.count, 0);
  EXPECT_TRUE(std::isnan(error.mean_translation));
  EXPECT_TRUE(std::isnan(error.sigma_translation));
  EXPECT_TRUE(std::isnan(error.mean_rotation));
}

TEST(Relations, OdometryReachesAStampFromBothSidesAndIsBlended) {
  // The robot stood until t = 5 and then drove 10 m by its odometry, which knows of 8 m only.
  const Trajectory odometry{{0.0, {}}, {5.0, {}}, {10.0, {8, 0, 0}}};
  // At t = 5 the estimate says 0 m from behind, 10 - 8 = 2 m from ahead: half way, 1 m.
  const RelationsError error = relations_error(straight(), {{0.0, 5.0, {1, 0, 0}}}, odometry);
  EXPECT_NEAR(error.mean_translation, 0.0, kRounding);
}

// Headings of 3.1 and -3.1 are 0.083 rad apart, and pi is between them.
TEST(Relations, HeadingsAreBlendedAcrossTheWrap) {
  const Trajectory estimate{{0.0, {0, 0, 0}}, {10.0, {0, 0, 3.1}}, {20.0, {0, 0, -3.1}}};
  const Trajectory stood{{0.0, {}}, {20.0, {}}};
  const RelationsError error = relations_error(estimate, {{0.0, 15.0, {0, 0, kPi}}}, stood);
  EXPECT_NEAR(error.mean_rotation, 0.0, 1e-9);
}

TEST(Relations, OdometryCarriesOnBeyondTheEnds) {
  const Trajectory odometry{{-3.0, {}}, {0.0, {3, 0, 0}}, {10.0, {13, 0, 0}}, {12.0, {15, 1, 0}}};
  const RelationsError error = relations_error(straight(), {{-3.0, 12.0, {15, 1, 0}}}, odometry);
  EXPECT_EQ(error.count, 1);
  EXPECT_NEAR(error.mean_translation, 0.0, kRounding);
}

TEST(Relations, DoNotDependOnTheOrderInTheFile) {
  Trajectory estimate{{0.0, {0, 0, 0}}, {5.0, {4, 1, 0.3}}, {10.0, {10, 0, 0}}};
  const std::vector<Relation> relations{{1.0, 7.0, {5, 0, 0}}};
  const double in_order = relations_error(estimate, relations).mean_translation;
  std::swap(estimate[0], estimate[2]);
  EXPECT_EQ(relations_error(estimate, relations).mean_translation, in_order);
}

// Where a path ends with two poses of one stamp there is no way between them: it ends at the one
// behind.
TEST(Relations, OfTwoPosesWithOneStampTheOneBehindCounts) {
  Trajectory estimate = straight();
  estimate.push_back({10.0, {11, 0, 0}});
  const RelationsError error = relations_error(estimate, {{0.0, 10.0, {11, 0, 0}}});
  EXPECT_NEAR(error.mean_translation, 0.0, kRounding);
}

TEST(Relations, ASinglePoseServesTheStampsAroundIt) {
  const RelationsError error = relations_error({{0.0, {1, 2, 0}}}, {{-1.0, 1.0, {}}});
  EXPECT_EQ(error.count, 1);
  EXPECT_EQ(error.mean_translation, 0.0);
}

std::string message_of(const std::string& content) {
  const std::string path = ::testing::TempDir() + "relations_test.relations";
  std::ofstream(path) << content;
  try {
    load_relations(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(RelationsFile, IsReadWithCommentsAndEmptyLines) {
  const std::string path = ::testing::TempDir() + "good.relations";
  std::ofstream(path)
      << "# stamps and motion\n\n976052905.167303 976052911.885496 -1 2 0 0 0 -0.5\n";
  const std::vector<Relation> relations = load_relations(path);
  ASSERT_EQ(relations.size(), 1U);
  EXPECT_EQ(relations[0].from_time, 976052905.167303);
  EXPECT_EQ(relations[0].to_time, 976052911.885496);
  EXPECT_EQ(relations[0].from_to, (Pose2{-1, 2, -0.5}));
}

TEST(RelationsFile, HeadingsAreWithinAHalfTurn) {
  const std::vector<Relation> relations = parse_relations("r", "0 1 2 3 0 0 0 4\n");
  EXPECT_NEAR(relations.at(0).from_to.theta, 4.0 - 2 * kPi, kRounding);
}

TEST(RelationsFile, NamesTheLineThatIsWrong) {
  EXPECT_THAT(message_of("1 2 0 0 0 0 0 0\n1 2 0 0 0 0\n"),
              HasSubstr("relations_test.relations:2: a relation has 8 numbers"));
  EXPECT_THAT(message_of("1 2 0 0 0 x 0 0\n"), HasSubstr(":1: 'x' is not a number"));
  EXPECT_THAT(message_of("1 2 0 0 0 nan 0 0\n"), HasSubstr(":1: 'nan' is not a number"));
  EXPECT_THAT(message_of(""), HasSubstr("holds no relation"));
}

}  // namespace
}  // namespace mapbed
