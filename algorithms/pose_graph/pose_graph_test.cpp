#include "algorithms/pose_graph/pose_graph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mapbed {
namespace {

using ::testing::ElementsAre;

PoseGraph<Pose2> joined(int nodes, const std::vector<std::pair<int, int>>& pairs) {
  PoseGraph<Pose2> graph{.nodes = std::vector<Pose2>(static_cast<std::size_t>(nodes))};
  for (const auto& [from, to] : pairs) graph.constraints.push_back({.from = from, .to = to});
  return graph;
}

TEST(PoseGraphComponents, AreNumberedInTheOrderOfTheirFirstNodes) {
  EXPECT_THAT(components_of(joined(7, {{6, 0}, {2, 1}, {4, 2}, {5, 5}})),
              ElementsAre(0, 1, 1, 2, 1, 3, 0));
}

TEST(PoseGraphComponents, EachHoldsItsFirstNodeUnlessOthersAreHeld) {
  PoseGraph<Pose2> graph = joined(6, {{0, 1}, {1, 2}, {3, 4}, {4, 5}});
  EXPECT_THAT(held_nodes(graph), ElementsAre(true, false, false, true, false, false));
  graph.held = {1, 2};
  EXPECT_THAT(held_nodes(graph), ElementsAre(false, true, true, true, false, false));
}

}  // namespace
}  // namespace mapbed
