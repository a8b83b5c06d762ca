#include "algorithms/pose_graph/graph_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/pose_graph/constraint_error.h"
#include "algorithms/pose_graph/testing/made_graphs.h"
#include "core/file/text_file.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string kPlane =
    "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0.1\nVERTEX_SE2 5 2 0 0.2\n"
    "EDGE_SE2 0 1 1 0 0.1 10 1 2 20 3 30\nEDGE_SE2 1 5 1 0 0.1 10 0 0 10 0 100\n";

PoseGraph<Pose2> plane(const std::string& text, const GraphFileOptions& options = {}) {
  return std::get<PoseGraph<Pose2>>(parse_graph("t.g2o", text, options).graph);
}
PoseGraph<Pose3> space(const std::string& text) {
  return std::get<PoseGraph<Pose3>>(parse_graph("t.g2o", text).graph);
}

template <class Pose>
void expect_equal(const PoseGraph<Pose>& a, const PoseGraph<Pose>& b, double tolerance) {
  ASSERT_EQ(a.nodes.size(), b.nodes.size());
  for (std::size_t i = 0; i < a.nodes.size(); ++i) {
    EXPECT_LE(constraint_error(Pose{}, a.nodes[i], b.nodes[i]).norm(), tolerance);
  }
  EXPECT_EQ(a.held, b.held);
  ASSERT_EQ(a.constraints.size(), b.constraints.size());
  for (std::size_t i = 0; i < a.constraints.size(); ++i) {
    const PoseConstraint<Pose>& p = a.constraints[i];
    const PoseConstraint<Pose>& q = b.constraints[i];
    EXPECT_EQ(std::tie(p.from, p.to, p.closes_loop), std::tie(q.from, q.to, q.closes_loop));
    EXPECT_LE(constraint_error(Pose{}, p.from_from_to, q.from_from_to).norm(), tolerance);
    EXPECT_LE((p.information - q.information).norm(), tolerance);
  }
}

template <class Pose>
class GraphFiles : public ::testing::Test {};
using Poses = ::testing::Types<Pose2, Pose3>;
TYPED_TEST_SUITE(GraphFiles, Poses);

TYPED_TEST(GraphFiles, ReadWhatWasWrittenInBothForms) {
  Rng rng(17);
  PoseGraph<TypeParam> graph = ring_without_noise<TypeParam>(rng, 12);
  graph.held = {0, 7};
  std::vector<std::int64_t> ids;
  for (int i = 0; i < 12; ++i) ids.push_back(i - 3);
  const TemporaryFolder folder;
  for (const std::string name : {"a.g2o", "a.g2o.gz", "a.toro", "a.graph.gz"}) {
    write_graph(folder.file(name), graph, ids);
    const GraphFile read = load_graph(folder.file(name));
    const bool is_exact = format_for(name) == GraphFormat::g2o || kDegreesOfFreedom<TypeParam> == 3;
    expect_equal(std::get<PoseGraph<TypeParam>>(read.graph), graph, is_exact ? 0.0 : 1e-12);
    EXPECT_EQ(read.ids, ids);
    EXPECT_EQ(read.format, format_for(name));
    EXPECT_TRUE(read.has_poses);
  }
}

TEST(GraphFile, HasTheUpperTriangleOfTheInformationByRows) {
  const PoseGraph<Pose2> graph = plane(kPlane);
  const PoseInformation<Pose2> expected =
      (PoseInformation<Pose2>() << 10, 1, 2, 1, 20, 3, 2, 3, 30).finished();
  EXPECT_EQ(graph.constraints[0].information, expected);
}

// http://www.openslam.org/toro: inf_ff inf_fs inf_ss inf_rr inf_fr inf_sr
TEST(GraphFile, HasTorosOwnOrderInToroFiles) {
  const PoseGraph<Pose2> graph = plane("EDGE2 0 1 1 0 0.1 10 1 20 30 2 3\n");
  EXPECT_EQ(graph.constraints[0].information,
            (PoseInformation<Pose2>() << 10, 1, 2, 1, 20, 3, 2, 3, 30).finished());
}

// An error of `a` rad about one axis costs a^2 I by TORO, and (a/2)^2 4 I here.
TEST(GraphFile, TakesTorosInformationInSpaceForThatOfAngles) {
  const PoseGraph<Pose3> graph = space(
      "VERTEX3 0 0 0 0 0 0 0\nVERTEX3 1 0 0 0 0 0.002 0\n"
      "EDGE3 0 1 0 0 0 0 0 0 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 5 0 0 7 0 9\n");
  EXPECT_NEAR(chi_square_of(graph.constraints[0], graph.nodes), 0.002 * 0.002 * 7.0, 1e-10);
}

TEST(GraphFile, TurnsByYawThenPitchThenRollInToroFiles) {
  const PoseGraph<Pose3> graph = space("VERTEX3 0 1 2 3 0.1 0.2 0.3\n");
  EXPECT_EQ(graph.nodes[0].rotation.coeffs(), rotation_of(0.3, 0.2, 0.1).coeffs());
}

TEST(GraphFile, NumbersNodesByTheirIdsWhateverTheyAre) {
  const GraphFile file = parse_graph(
      "t", "VERTEX_SE2 70 1 0 0\nVERTEX_SE2 -5 2 0 0\nEDGE_SE2 70 -5 1 0 0 1 0 0 1 0 1\n");
  EXPECT_THAT(file.ids, ElementsAre(-5, 70));
  const auto& graph = std::get<PoseGraph<Pose2>>(file.graph);
  EXPECT_EQ(graph.nodes[0].x, 2.0);
  EXPECT_EQ(graph.constraints[0].from, 1);
}

TEST(GraphFile, ClosesALoopWhereIdsAreNotConsecutiveUnlessToldOtherwise) {
  EXPECT_FALSE(plane(kPlane).constraints[0].closes_loop);
  EXPECT_TRUE(plane(kPlane).constraints[1].closes_loop);
  EXPECT_TRUE(plane(kPlane, {LoopRule::all}).constraints[0].closes_loop);
  EXPECT_FALSE(plane(kPlane, {LoopRule::none}).constraints[1].closes_loop);
}

TEST(GraphFile, OfEdgesAloneHasNoPoses) {
  const GraphFile file = parse_graph("t", "EDGE_SE2 3 4 1 0 0 1 0 0 1 0 1\n");
  EXPECT_FALSE(file.has_poses);
  EXPECT_THAT(file.ids, ElementsAre(3, 4));
}

TEST(GraphFile, HoldsNodesThatAreFixed) {
  EXPECT_THAT(plane(kPlane + "FIX 5 0\n").held, ElementsAre(2, 0));
}

std::string remarks_of(const std::string& text) {
  return fmt::format("{}", fmt::join(parse_graph("t", text).remarks, "\n"));
}

TEST(GraphFile, CountsEdgesThatAreThereTwiceAndSaysSo) {
  const std::string again = kPlane + "EDGE_SE2 1 0 -1 0 -0.1 10 0 0 10 0 100\n";
  EXPECT_EQ(plane(again).constraints.size(), 3u);
  EXPECT_THAT(remarks_of(again),
              HasSubstr("edges between nodes that another edge joins already: 1; each counts"));
}

TEST(GraphFile, SaysWhatItLeavesOut) {
  EXPECT_EQ(remarks_of(kPlane + "# comment\nPARAMS_SE2OFFSET 0 0 0 0\n"), "");
  EXPECT_THAT(remarks_of(kPlane + "EDGE_SE2_XY 0 9 1 1 1 0 1\n"),
              HasSubstr("lines 'EDGE_SE2_XY' are left out, as nothing is known of them here: 1"));
  EXPECT_THAT(remarks_of(kPlane + "EDGE_SE2 1 1 1 0 0 1 0 0 1 0 1\n"),
              HasSubstr("line 6: an edge from node 1 to itself is left out"));
  EXPECT_THAT(remarks_of(kPlane + "VERTEX_SE2 1 1 0 0.1\n"), HasSubstr("node 1 is given twice"));
}

TEST(GraphFile, RefusesWhatMakesNoSenseWithPlaceAndRemedy) {
  const auto expect = [](const std::string& line, std::string_view part) {
    EXPECT_INPUT_ERROR(parse_graph("t.g2o", kPlane + line), part);
  };
  expect("EDGE_SE2 1 9 1 0 0 1 0 0 1 0 1", "t.g2o:6: an edge joins node 9, which has no vertex");
  expect("EDGE_SE2 1 5 nan 0 0 1 0 0 1 0 1", "t.g2o:6: a number of the pose is not finite");
  expect("EDGE_SE2 1 5 1 0 0 1 0 0 inf 0 1", "number of the information matrix is not finite");
  expect("EDGE_SE2 1 5 1 0 0 1 0 0 1 0", "t.g2o:6: ends within the information matrix");
  expect("EDGE_SE2 1 5 1 0 x 1 0 0 1 0 1", "'x' is no number of the pose");
  expect("EDGE_SE2 1 5 1 0 0 1 0 0 1 0 1 7", "goes on with '7'");
  expect("EDGE_SE2 1 5 1 0 0 1 2 0 1 0 1", "the information matrix has the eigenvalue -1");
  expect("EDGE_SE2 1 5.5 1 0 0 1 0 0 1 0 1", "'5.5' is no node's id");
  expect("VERTEX_SE2 1 2 0 0", "t.g2o:6: node 1 has another pose in line 2");
  expect("VERTEX_SE3:QUAT 7 0 0 0 0 0 0 1", "VERTEX_SE3:QUAT is in space, line 1 is in the plane");
  expect("FIX 77", "t.g2o:6: FIX names node 77");
  EXPECT_INPUT_ERROR(parse_graph("t", "VERTEX_SE3:QUAT 7 0 0 0 1 0 0 1"),
                     "the quaternion has length 1.41, not 1");
  EXPECT_INPUT_ERROR(parse_graph("t", "hello\n"), "holds no pose graph");
  EXPECT_INPUT_ERROR(parse_graph("t", "EDGE_SE2 1 1 1 0 0 1 0 0 1 0 1"), "holds no node");
  EXPECT_INPUT_ERROR(load_graph("/nowhere.g2o"), "/nowhere.g2o");
}

TEST(GraphFile, TakesInformationWithoutRankAndRoundedZeros) {
  EXPECT_EQ(plane("EDGE_SE2 0 1 1 0 0 1 0 0 1 0 0\n").constraints.size(), 1u);
  EXPECT_EQ(plane("EDGE_SE2 0 1 1 0 0 1e3 0 0 1 0 -1e-7\n").constraints.size(), 1u);
}

}  // namespace
}  // namespace mapbed
