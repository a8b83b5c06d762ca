#include "bench/figures/revision_figures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/plot/testing/well_formed.h"
#include "bench/results/testing/example_associations.h"
#include "core/image/png.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

using ::testing::DoubleEq;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(RevisionFigures, TheLikelihoodStandsOverTheEndsOfLocalMapsUnderBothDecisions) {
  AssociationTree tree = example_associations();
  for (std::size_t i = 0; i < tree.nodes.size(); ++i)
    tree.nodes[i].newest = -static_cast<double>(i);
  const Plot plot = likelihood_plot(tree, "lazy");
  ASSERT_THAT(plot.series, SizeIs(2));
  EXPECT_THAT(plot.series[0].x, ElementsAre(5.0, 10.0, 15.0, 20.0, 25.5));
  EXPECT_THAT(plot.series[0].y, ElementsAre(0.0, -1.0, -2.0, -4.0, -6.0));
  EXPECT_THAT(plot.series[1].y, ElementsAre(-10.0, -10.0, -10.25, -9.75, -9.125));
  EXPECT_TRUE(is_well_formed(svg_of(plot)));
  EXPECT_TRUE(is_well_formed(svg_of(likelihood_plot({}))));
}

TEST(RevisionFigures, TheLargestRevisionChangedMostAndThenGainedMost) {
  AssociationTree tree;
  EXPECT_FALSE(largest_revision(tree));
  const auto revision = [](int at, int changed, double gain) {
    return AssociationTree::Revision{
        .at = at, .changed = changed, .log_likelihood_before = 0.0, .log_likelihood_after = gain};
  };
  tree.revisions = {revision(3, 1, 50.0), revision(5, 2, 10.0), revision(7, 2, 20.0),
                    revision(9, 1, 90.0)};
  EXPECT_EQ(largest_revision(tree)->at, 7);
}

// A scan each second in a room of 8 m x 6 m; of the last one neither path knows yet.
TEST(RevisionFigures, TheMapsShowTheLogUpToTheRevisionAlongEachPath) {
  SensorLog log;
  Trajectory before, after;
  for (int i = 0; i < 4; ++i) {
    log.push_back(scan_of(rectangular_room(4.0, 3.0), Pose2{0.5 * i, 0.0, 0.0}, {}, 1.0 * i));
    if (i == 3) break;
    after.push_back({1.0 * i, Pose2{0.5 * i, 0.0, 0.0}});
    before.push_back({1.0 * i, Pose2{0.5 * i, i == 2 ? 2.0 : 0.0, 0.0}});
  }
  AssociationTree tree = example_associations();
  EXPECT_THAT(revision_maps(tree, log, {}), IsEmpty()) << "no paths: as read from a file";
  tree.revisions[0].path_before = before;
  tree.revisions[0].path_after = after;
  const auto maps = revision_maps(tree, log, {});
  ASSERT_THAT(maps, SizeIs(2));
  EXPECT_EQ(maps[0].first, "before_revision.png");
  EXPECT_EQ(maps[1].first, "after_revision.png");
  EXPECT_NE(maps[0].second, maps[1].second);
  tree.revisions[0].path_before = after;
  EXPECT_EQ(revision_maps(tree, log, {})[0].second, maps[1].second);
}

}  // namespace
}  // namespace mapbed
