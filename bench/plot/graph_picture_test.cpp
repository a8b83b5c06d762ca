#include "bench/plot/graph_picture.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/plot/testing/well_formed.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// A square of 10 m, driven round and closed.
PoseGraph<Pose2> square() {
  PoseGraph<Pose2> graph{.nodes = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}}};
  for (int i = 0; i < 3; ++i) graph.constraints.push_back({.from = i, .to = i + 1});
  graph.constraints.push_back({.from = 3, .to = 0, .closes_loop = true});
  return graph;
}

TEST(GraphPicture, DrawsOdometryAsOnePathAndNamesWhatThereIs) {
  const std::string svg = graph_svg("square & more", "", {{"before", square()}});
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, HasSubstr("square &amp; more"));
  // Of the three edges of the path one moves, three draw: a square, up to the scale.
  const std::size_t path = svg.find("<path d=\"M", svg.find("before"));
  const std::string closing = svg.substr(path, svg.find('"', path + 10) - path);
  EXPECT_EQ(std::count(closing.begin(), closing.end(), 'L'), 1);
  EXPECT_THAT(svg, HasSubstr("loop closures"));
  EXPECT_THAT(svg, Not(HasSubstr("switched off")));
  EXPECT_THAT(svg, HasSubstr(">2 m<"));  // of 3 m that are free, 1, 2 or 5 times a power of ten
}

TEST(GraphPicture, ShowsWhatWasSwitchedOff) {
  const std::string svg =
      graph_svg("t", "", {{"before", square()}, {"after", square(), {1.0, 1.0, 1.0, 0.1}}});
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, HasSubstr("switched off"));
}

TEST(GraphPicture, TakesGraphsInSpaceAndEmptyOnes) {
  PoseGraph<Pose3> tower{.nodes = {Pose3{}, Pose3{{0, 0, 5}}}};
  tower.constraints.push_back({.from = 0, .to = 1});
  EXPECT_TRUE(is_well_formed(graph_svg("t", "", {{"a", tower}, {"b", PoseGraph<Pose2>{}}})));
}

}  // namespace
}  // namespace mapbed
