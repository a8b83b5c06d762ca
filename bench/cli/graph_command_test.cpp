#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "algorithms/pose_graph/graph_file.h"
#include "bench/cli/testing/command_test.h"
#include "bench/plot/testing/well_formed.h"

namespace mapbed {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// Three nodes on a line, measured by steps of 1 m and by 2.3 m for both: see
// GraphOptimizerOnALine.SharesTheErrorAsTheVariancesAre.
constexpr const char* kEdges =
    "EDGE_SE2 10 11 1 0 0 1 0 0 1 0 1\nEDGE_SE2 11 12 1 0 0 1 0 0 1 0 1\n"
    "EDGE_SE2 10 12 2.3 0 0 0.25 0 0 0.25 0 0.25\n";
constexpr const char* kNodes = "VERTEX_SE2 10 0 0 0\nVERTEX_SE2 11 1 0 0\nVERTEX_SE2 12 2 0 0\n";

class GraphCommand : public CommandTest {
 protected:
  GraphCommand() { write("line.g2o", std::string(kNodes) + kEdges); }
  nlohmann::json report(const std::string& folder = "line_graph") const {
    return nlohmann::json::parse(text(folder + "/graph.json"));
  }
};

TEST_F(GraphCommand, OptimisesReportsAndDraws) {
  const Outcome outcome = call({"graph", "line.g2o"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("line.g2o: 3 nodes, 3 edges, 1 of which close loops, 1 "
                                           "component;"),
                                 HasSubstr("written to line_graph")));
  EXPECT_EQ(report()["nodes"], 3);
  EXPECT_EQ(report()["components"], 1);
  EXPECT_TRUE(report()["converged"]);
  EXPECT_NEAR(report()["chi2_of_file"], 0.3 * 0.3 / 4.0, 1e-12);
  EXPECT_NEAR(report()["chi2_after"], 0.3 * 0.3 / 6.0, 1e-12);
  const GraphFile written = load_graph(path("line_graph/graph.g2o"));
  EXPECT_NEAR(std::get<PoseGraph<Pose2>>(written.graph).nodes[2].x, 2.1, 1e-9);
  EXPECT_EQ(written.ids, (std::vector<std::int64_t>{10, 11, 12}));
  EXPECT_TRUE(is_well_formed(text("line_graph/picture.svg")));

  // Once more, by its own configuration.
  const std::string json = text("line_graph/graph.g2o");
  EXPECT_EQ(call({"graph", "line.g2o", "--config", "line_graph/config.yaml"}).status, 0);
  EXPECT_EQ(text("line_graph/graph.g2o"), json);
}

TEST_F(GraphCommand, FindsPosesOfEdgesAlone) {
  write("edges.g2o", kEdges);
  for (const char* start : {"best", "chordal", "spanning_tree"}) {
    EXPECT_EQ(call({"graph", "edges.g2o", "--set", std::string("start=") + start}).status, 0);
    EXPECT_NEAR(report("edges_graph")["chi2_after"], 0.015, 1e-12);
    EXPECT_FALSE(report("edges_graph").contains("chi2_of_file"));
  }
  expect_refusal({"graph", "edges.g2o", "--set", "start=file"},
                 "edges.g2o: has edges alone, and no poses to begin with");
}

TEST_F(GraphCommand, SaysWhichLoopClosuresItSwitchedOff) {
  // The wrong one says 50 m.
  write("wrong.g2o", std::string(kNodes) + kEdges + "EDGE_SE2 10 12 50 0 0 1 0 0 1 0 1\n");
  const Outcome outcome =
      call({"graph", "wrong.g2o", "--set", "optimization.robust.loss=graduated_truncated"});
  EXPECT_THAT(outcome.out, HasSubstr("switched off, by a weight below one half: 1 of 2 loop"));
  EXPECT_THAT(outcome.err, HasSubstr("edges between nodes that another edge joins already: 1"));
  ASSERT_EQ(report("wrong_graph")["switched_off"].size(), 1u);
  EXPECT_EQ(report("wrong_graph")["switched_off"][0]["to"], 12);
  EXPECT_THAT(text("wrong_graph/picture.svg"), HasSubstr("switched off"));
}

// With as much information in x as in y, whatever that of the heading, the graph's own problem.
TEST_F(GraphCommand, CertifiesTheGlobalOptimumWhereNothingIsDoubted) {
  EXPECT_THAT(call({"graph", "line.g2o"}).out,
              HasSubstr("certified as the global optimum of this graph: f = 0.015"));
  EXPECT_TRUE(report()["certificate"]["certified"]);
  EXPECT_EQ(report()["certificate"]["problem"], "own");
  EXPECT_NEAR(report()["certificate"]["objective"], 0.015, 1e-12);

  write("other.g2o", std::string(kNodes) + kEdges + "EDGE_SE2 12 10 -2 0 0 1 0 0 4 0 1\n");
  EXPECT_THAT(call({"graph", "other.g2o"}).out,
              HasSubstr("of the graph with isotropic noise in place of its own"));
  EXPECT_EQ(report("other_graph")["certificate"]["problem"], "isotropic");

  for (const char* setting : {"certify=false", "optimization.robust.loss=cauchy"}) {
    EXPECT_THAT(call({"graph", "line.g2o", "--set", setting}).out, Not(HasSubstr("certified")));
    EXPECT_FALSE(report().contains("certificate"));
  }
}

TEST_F(GraphCommand, SaysThatComponentsAreNotJoined) {
  write("two.g2o", std::string(kNodes) + kEdges + "VERTEX_SE2 20 5 5 0\nVERTEX_SE2 21 6 5 0\n" +
                       "EDGE_SE2 20 21 1 0 0 1 0 0 1 0 1\n");
  EXPECT_THAT(call({"graph", "two.g2o"}).err,
              HasSubstr("the graph has 2 components that nothing joins"));
  EXPECT_EQ(report("two_graph")["components"], 2);
}

TEST_F(GraphCommand, WritesToroOfToro) {
  write("line.toro", "EDGE2 0 1 1 0 0 1 0 1 1 0 0\n");
  EXPECT_EQ(call({"graph", "line.toro", "-o", "out"}).status, 0);
  EXPECT_THAT(text("out/graph.toro"), HasSubstr("EDGE2 0 1 1 0 0 1 0 1 1 0 0\n"));
}

TEST_F(GraphCommand, RefusesWrongFilesOptionsAndFolders) {
  expect_refusal({"graph", "none.g2o"}, "none.g2o");
  expect_refusal({"graph", "line.g2o", "--set", "optimisation.robust.loss=huber"},
                 "did you mean 'optimization");
  write("broken.g2o", std::string(kNodes) + "EDGE_SE2 10 13 1 0 0 1 0 0 1 0 1\n");
  expect_refusal({"graph", "broken.g2o"}, "broken.g2o:4: an edge joins node 13");
  EXPECT_EQ(call({"graph", "line.g2o", "-o", "out"}).status, 0);
  write("other.g2o", kEdges);
  expect_refusal({"graph", "other.g2o", "-o", "out"}, "line.g2o");
  write("picture.svg", "mine");
  expect_refusal({"graph", "line.g2o", "-o", "."}, "picture.svg");
  EXPECT_EQ(text("picture.svg"), "mine");
}

}  // namespace
}  // namespace mapbed
