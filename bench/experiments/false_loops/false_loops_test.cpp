#include "bench/experiments/false_loops/false_loops.h"

#include <fstream>
#include <map>

#include <gmock/gmock.h>

#include "algorithms/pose_graph/constraint_error.h"
#include "bench/experiments/false_loops/added_false_loops.h"
#include "core/geometry/angle.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

template <class Pose>
class FalseLoops : public ::testing::Test {
 protected:
  static KnownGraph<Pose> drive(std::uint64_t seed, int poses = 600) {
    return lattice_drive<Pose>({.poses = poses, .blocks = 3}, Rng(seed));
  }
  static int loops_of(const PoseGraph<Pose>& graph) {
    int loops = 0;
    for (const auto& constraint : graph.constraints) loops += constraint.closes_loop;
    return loops;
  }
};
using Poses = ::testing::Types<Pose2, Pose3>;
TYPED_TEST_SUITE(FalseLoops, Poses);

TYPED_TEST(FalseLoops, ADriveGoesAMeterAtATimeThroughItsLattice) {
  const auto known = this->drive(1);
  ASSERT_EQ(known.truth.size(), 600U);
  for (std::size_t i = 0; i + 1 < known.truth.size(); ++i) {
    const TypeParam step = motion_between(known.truth[i], known.truth[i + 1]);
    EXPECT_NEAR(distance(step, TypeParam{}), 1.0, 1e-9);
    EXPECT_LE(distance(known.truth[i], TypeParam{}), 15.0 * std::sqrt(3.0) + 1e-9);
  }
  EXPECT_NE(known.truth, this->drive(2).truth);
  EXPECT_EQ(known.truth, this->drive(1).truth);
}

// The sum of `n` chi-squares of `k` freedoms has mean nk and variance 2nk.
TYPED_TEST(FalseLoops, RightConstraintsErrAsTheirInformationSays) {
  const auto known = this->drive(3);
  double sum = 0.0;
  for (const auto& constraint : known.graph.constraints) {
    sum += chi_square_of(constraint, known.truth);
  }
  const double freedoms =
      static_cast<double>(known.graph.constraints.size() * kDegreesOfFreedom<TypeParam>);
  EXPECT_NEAR(sum, freedoms, 4.0 * std::sqrt(2.0 * freedoms));
}

// Round a block of 2 m it is there again after 8 poses, which closes no loop yet.
TYPED_TEST(FalseLoops, LoopsAreClosedWhereTheRobotHasBeen) {
  const auto known =
      lattice_drive<TypeParam>({.poses = 600, .block = 2, .blocks = 4, .loops = 1.0}, Rng(4));
  EXPECT_GT(this->loops_of(known.graph), 50);
  for (const auto& constraint : known.graph.constraints) {
    const auto from = static_cast<std::size_t>(constraint.from);
    const auto to = static_cast<std::size_t>(constraint.to);
    if (!constraint.closes_loop) {
      EXPECT_EQ(from + 1, to);
      continue;
    }
    EXPECT_GE(to - from, 20U);
    EXPECT_NEAR(distance(known.truth[from], known.truth[to]), 0.0, 1e-9);
  }
}

TYPED_TEST(FalseLoops, NodesBeginWhereOdometryHasThem) {
  const auto known = this->drive(5);
  for (const auto& constraint : known.graph.constraints) {
    if (!constraint.closes_loop) {
      EXPECT_NEAR(chi_square_of(constraint, known.graph.nodes), 0.0, 1e-9);
    }
  }
}

TYPED_TEST(FalseLoops, AreAShareOfAllLoopClosuresAndFarOffTheTruth) {
  for (const FalseLoopKind kind : {FalseLoopKind::random, FalseLoopKind::grouped}) {
    auto known = this->drive(6);
    const std::size_t right = known.graph.constraints.size();
    const int right_loops = this->loops_of(known.graph);
    add_false_loops({.kind = kind, .share = 0.3}, Rng(7), known);
    const int added = this->loops_of(known.graph) - right_loops;
    EXPECT_NEAR(static_cast<double>(added) / (added + right_loops), 0.3, 0.5 / right_loops);
    EXPECT_EQ(known.graph.constraints.size(), right + static_cast<std::size_t>(added));
    for (std::size_t i = right; i < known.graph.constraints.size(); ++i) {
      EXPECT_GE(chi_square_of(known.graph.constraints[i], known.truth), 100.0);
      EXPECT_GE(known.graph.constraints[i].to - known.graph.constraints[i].from, 20);
    }
  }
}

// Round the loop of two neighbours of a run and of odometry nothing is left but their noise; of
// others much is.
TYPED_TEST(FalseLoops, OfARunAgreeWithOneAnother) {
  for (const FalseLoopKind kind : {FalseLoopKind::random, FalseLoopKind::grouped}) {
    auto known = this->drive(8);
    const std::size_t right = known.graph.constraints.size();
    add_false_loops({.kind = kind, .share = 0.3, .group = 5}, Rng(9), known);
    int agree = 0, all = 0;
    for (std::size_t i = right; i + 1 < known.graph.constraints.size(); ++i) {
      const auto& a = known.graph.constraints[i];
      const auto& b = known.graph.constraints[i + 1];
      const auto true_motion = [&](int from, int to) {
        return motion_between(known.truth[static_cast<std::size_t>(from)],
                              known.truth[static_cast<std::size_t>(to)]);
      };
      const TypeParam expected =
          true_motion(b.from, a.from) * a.from_from_to * true_motion(a.to, b.to);
      ++all;
      agree += distance(motion_between(expected, b.from_from_to), TypeParam{}) < 0.5;
    }
    // Four of five, and fewer by what the last run lacks.
    if (kind == FalseLoopKind::grouped) {
      EXPECT_NEAR(agree, 0.8 * all, 2.0);
    } else {
      EXPECT_LT(agree, 0.1 * all);
    }
  }
}

TYPED_TEST(FalseLoops, OfASmallerShareAreTheFirstOfALargerOne) {
  auto few = this->drive(10);
  auto many = this->drive(10);
  add_false_loops({.share = 0.1}, Rng(11), few);
  add_false_loops({.share = 0.5}, Rng(11), many);
  ASSERT_LT(few.graph.constraints.size(), many.graph.constraints.size());
  const auto& last = few.graph.constraints.back();
  const auto& same = many.graph.constraints[few.graph.constraints.size() - 1];
  EXPECT_EQ(last.from, same.from);
  EXPECT_EQ(last.to, same.to);
  EXPECT_EQ(last.from_from_to, same.from_from_to);
}

TYPED_TEST(FalseLoops, OfAGraphThatIsTooShortAreRefused) {
  auto known = this->drive(12, 60);
  for (auto& constraint : known.graph.constraints) constraint.closes_loop = true;
  EXPECT_INPUT_ERROR(
      add_false_loops({.kind = FalseLoopKind::grouped, .share = 0.5, .group = 30}, Rng(1), known),
      "the graph is too short");
}

std::map<std::string, double> values_of(const Settings& settings) {
  RunInput input;
  input.rng = Rng(20);
  const RunOutcome outcome = false_loops_experiment().configure(settings).make(input);
  return {outcome.values.begin(), outcome.values.end()};
}

TEST(FalseLoopsExperiment, TellsWhoSurvivesAndWhatWasBelieved) {
  const auto run = [](const std::string& loss, const std::string& share) {
    return values_of({{"drive.poses", "300"},
                      {"drive.blocks", "3"},
                      {"false_loops.share", share},
                      {"optimization.robust.loss", loss}});
  };
  const auto clean = run("none", "0");
  EXPECT_EQ(clean.at("success"), 1.0);
  EXPECT_NEAR(clean.at("position_error"), clean.at("clean_error"), 1e-3);
  EXPECT_EQ(clean.at("false_loops"), 0.0);
  EXPECT_EQ(clean.at("right_lost"), 0.0);
  EXPECT_FALSE(clean.contains("false_kept"));

  const auto believing = run("none", "0.2");
  EXPECT_EQ(believing.at("success"), 0.0);
  EXPECT_EQ(believing.at("false_kept"), 1.0);
  EXPECT_GT(believing.at("position_error"), 1.0);

  const auto doubting = run("graduated_truncated", "0.2");
  EXPECT_EQ(doubting.at("success"), 1.0);
  EXPECT_EQ(doubting.at("false_kept"), 0.0);
  EXPECT_LT(doubting.at("right_lost"), 0.1);
  EXPECT_EQ(doubting.at("false_loops"), believing.at("false_loops"));
}

TEST(FalseLoopsExperiment, OfAFileTakesItsOptimumForTheTruth) {
  const TemporaryFolder folder;
  std::ofstream file(folder.file("square.g2o"));
  for (int i = 0; i < 8; ++i) file << "VERTEX_SE2 " << i << " 0 0 0\n";
  for (int i = 0; i < 7; ++i) {
    file << "EDGE_SE2 " << i << " " << i + 1 << " 1 0 " << kPi / 2.0 << " 100 0 0 100 0 100\n";
  }
  file << "EDGE_SE2 0 4 0.02 0 0 100 0 0 100 0 100\n";
  file.close();
  const auto values = values_of({{"graph", "file"}, {"file", folder.file("square.g2o")}});
  EXPECT_NEAR(values.at("clean_error"), 0.0, 1e-6);
  EXPECT_NEAR(values.at("position_error"), 0.0, 1e-4);
  EXPECT_EQ(values.at("success"), 1.0);
}

TEST(FalseLoopsExperiment, SaysWhichFileIsNotHere) {
  const auto configured =
      false_loops_experiment().configure({{"graph", "file"}, {"file", "nowhere.g2o"}});
  EXPECT_EQ(configured.missing, "the graph 'nowhere.g2o' is not here");
}

}  // namespace
}  // namespace mapbed
