#include "bench/experiments/slam_evaluator.h"

#include <cmath>
#include <map>

#include <gmock/gmock.h>

#include "bench/results/testing/example_associations.h"
#include "core/geometry/angle.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

constexpr int kScans = 11;

// A drive of 5 m through a room of 8.1 m x 4.1 m, whose walls run along the middle of cells.
class SlamEvaluatorOf : public ::testing::Test {
 protected:
  SlamEvaluatorOf() : true_map_{.resolution = 0.1, .width = 90, .height = 50} {
    true_map_.origin = {-4.5, -2.5};
    for (int y = 0; y < true_map_.height; ++y) {
      for (int x = 0; x < true_map_.width; ++x) {
        const bool is_outside = x < 4 || x > 85 || y < 4 || y > 45;
        const bool is_wall = x == 4 || x == 85 || y == 4 || y == 45;
        true_map_.cells.push_back(is_outside ? TrueCell::unknown
                                  : is_wall  ? TrueCell::occupied
                                             : TrueCell::free);
      }
    }
    const TestLaser all_round{.beams = 720, .first_bearing = -kPi, .bearing_step = radians(0.5)};
    for (int i = 0; i < kScans; ++i) {
      const Pose2 pose{-2.5 + 0.5 * i, 0.2, 0.0};
      input_.log.push_back(scan_of(rectangular_room(8.1, 4.1), pose, all_round, i));
      input_.truth.push_back({static_cast<double>(i), pose});
    }
    estimate_.trajectory = input_.truth;
    for (const Metric& metric : slam_metrics()) input_.wanted.insert(metric.name);
    options_.map.resolution = 0.1;
    options_.path_length = 1.0;
  }

  void know_the_map() {
    input_.true_map = [this](double) -> const TrueMap& { return true_map_; };
  }
  // Everything from the sixth pose on.
  void shift_the_end(double dy) {
    for (std::size_t i = 5; i < estimate_.trajectory.size(); ++i)
      estimate_.trajectory[i].pose.y += dy;
  }
  std::map<std::string, double> values() {
    SlamEvaluator evaluator(options_, input_, estimate_);
    const auto pairs = evaluator.values();
    return {pairs.begin(), pairs.end()};
  }

  TrueMap true_map_;
  EvaluationOptions options_;
  RunInput input_;
  Estimate estimate_;
};

TEST_F(SlamEvaluatorOf, TheTruePathIsASuccess) {
  know_the_map();
  auto value = values();
  EXPECT_DOUBLE_EQ(value["largest_error"], 0.0);
  EXPECT_NEAR(value["translation_error"], 0.0, 1e-9);
  EXPECT_DOUBLE_EQ(value["map_f1"], 1.0);
  EXPECT_DOUBLE_EQ(value["spurious_cells"], 0.0);
  EXPECT_DOUBLE_EQ(value["free_as_occupied"], 0.0);
  EXPECT_DOUBLE_EQ(value["doubled_walls"], 0.0);
  EXPECT_DOUBLE_EQ(value["excess_doubled_walls"], 0.0);
  EXPECT_DOUBLE_EQ(value["success"], 1.0);
  EXPECT_DOUBLE_EQ(value["failures"], 0.0);
}

TEST_F(SlamEvaluatorOf, AWallDrawnTwiceIsNoSuccessHoweverSmallTheError) {
  know_the_map();
  shift_the_end(0.5);
  auto value = values();
  EXPECT_NEAR(value["largest_error"], 0.5, 1e-9);
  EXPECT_GT(value["excess_doubled_walls"], options_.success_doubled_walls);
  EXPECT_GT(value["spurious_cells"], 20.0);
  EXPECT_LT(value["sharpness"], -0.01);
  EXPECT_DOUBLE_EQ(value["success"], 0.0);
  options_.success_doubled_walls = 1.0;
  EXPECT_DOUBLE_EQ(values()["success"], 1.0);
}

TEST_F(SlamEvaluatorOf, APathFarOffFailsInWords) {
  shift_the_end(2.5);
  EXPECT_DOUBLE_EQ(values()["success"], 0.0);  // whatever the walls, which nobody knows here
  EXPECT_DOUBLE_EQ(values()["failures"], 1.0);
  EXPECT_EQ(SlamEvaluator(options_, input_, estimate_).failure(), "largest position error 2.50 m");
}

// A first pose turned by 0.1 rad swings the rest of the 5 m round by a chord; a last one turned
// says nothing of where the robot was.
TEST_F(SlamEvaluatorOf, TheLargestErrorIsThatWithTheFirstPosesAligned) {
  estimate_.trajectory.back().pose.theta = 0.3;
  EXPECT_NEAR(values()["largest_error"], 0.0, 1e-9);
  estimate_.trajectory.front().pose.theta = 0.1;
  EXPECT_NEAR(values()["largest_error"], 2.0 * 5.0 * std::sin(0.05), 1e-9);
}

TEST_F(SlamEvaluatorOf, ALogWithoutTruthIsEvaluatedByItselfAlone) {
  input_.truth.clear();
  for (const auto& [name, value] : values()) {
    const bool has_value =
        name == "sharpness" || name == "untrusted_scans" || name == "path_length";
    EXPECT_EQ(std::isnan(value), !has_value) << name;
  }
  EXPECT_NEAR(values()["path_length"], 5.0, 1e-9);
  EXPECT_EQ(SlamEvaluator(options_, input_, estimate_).failure(), "");
}

// Odometry says that the robot stood still until 0.9 s and then drove the half metre.
TEST_F(SlamEvaluatorOf, StampsOfRelationsAreReachedByOdometryOrLinearly) {
  MeasuredRelations measured;
  measured.relations = {{0.0, 0.5, Pose2{}}, {0.0, 1.0, Pose2{0.5, 0.0, 0.0}}};
  measured.odometry = {{0.0, Pose2{}}, {0.9, Pose2{}}, {1.0, Pose2{0.5, 0.0, 0.0}}};
  input_.relations = [&]() -> const MeasuredRelations& { return measured; };
  EXPECT_NEAR(values()["relations_translation"], 0.0, 1e-9);
  EXPECT_EQ(values()["relations_compared"], 2.0);
  options_.relation_stamps = RelationStamps::linear;
  EXPECT_NEAR(values()["relations_translation"], 0.125, 1e-9);         // of 0.25 m and 0
  EXPECT_NEAR(values()["relations_translation_spread"], 0.125, 1e-9);  // the same
}

TEST_F(SlamEvaluatorOf, AnErrorOfALogIsOverRelationsOrWithoutAnyOverPairs) {
  EXPECT_TRUE(std::isnan(values()["log_error"]));
  const std::vector<Relation> pairs{{0.0, 2.0, Pose2{1.25, 0.0, 0.0}}};
  input_.pairs = [&]() -> const std::vector<Relation>& { return pairs; };
  EXPECT_NEAR(values()["log_error"], 0.25, 1e-9);  // 1 m was driven
  MeasuredRelations measured;
  measured.relations = {{0.0, 2.0, Pose2{1.5, 0.0, 0.0}}};
  input_.relations = [&]() -> const MeasuredRelations& { return measured; };
  EXPECT_NEAR(values()["log_error"], 0.5, 1e-9);
}

TEST_F(SlamEvaluatorOf, OnlyWhatIsWantedIsWorkedOut) {
  input_.wanted = {"largest_error"};
  input_.true_map = [](double) -> const TrueMap& { throw std::logic_error("not wanted"); };
  EXPECT_EQ(values().size(), 1u);
}

TEST_F(SlamEvaluatorOf, CountsWhatASearchOfDataAssociationsTookBack) {
  EXPECT_TRUE(std::isnan(values()["revisions"])) << "there was no search";
  estimate_.associations = example_associations();
  estimate_.associations->revisions.push_back({.changed = 3});
  estimate_.associations->given_up = 1;
  EXPECT_EQ(values()["revisions"], 2.0);
  EXPECT_EQ(values()["revised_decisions"], 5.0);
  EXPECT_EQ(values()["searches_given_up"], 1.0);
}

}  // namespace
}  // namespace mapbed
