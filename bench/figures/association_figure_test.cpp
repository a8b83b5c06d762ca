#include "bench/figures/association_figure.h"

#include <gmock/gmock.h>

#include "bench/plot/testing/well_formed.h"
#include "bench/results/testing/example_associations.h"

namespace mapbed {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const PlotSeries& series_of(const Plot& plot, const std::string& name) {
  static const PlotSeries none;
  for (const PlotSeries& series : plot.series) {
    if (series.name == name) return series;
  }
  return none;
}

TEST(AssociationFigure, WhatIsChosenLiesAtZeroAndWhatWasTakenBackFallsBelowIt) {
  const Plot plot = association_plot(example_associations(), "lazy");
  EXPECT_THAT(series_of(plot, "chosen in the end").x, ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(series_of(plot, "chosen in the end").y, ElementsAre(0, 0, 0, 0, 0));
  const PlotSeries& left = series_of(plot, "taken back");
  ASSERT_EQ(left.y.size(), 6u) << "two branches, each with a gap behind it";
  EXPECT_EQ(left.y[0], 0.0);
  EXPECT_EQ(left.y[1], 2.0) << "-40 against -42: it looked better";
  EXPECT_EQ(left.x[4], 4.0);
  EXPECT_EQ(left.y[4], -90.0 + 51.125);
}

TEST(AssociationFigure, MarksRevisionsWithTheLikelihoodsBeforeAndAfter) {
  const Plot plot = association_plot(example_associations());
  EXPECT_THAT(series_of(plot, "before a revision").x, ElementsAre(4));
  EXPECT_THAT(series_of(plot, "before a revision").y, ElementsAre(-90.0 + 51.125));
  EXPECT_THAT(series_of(plot, "after it").y, ElementsAre(0.0));
  EXPECT_EQ(plot.title, "Data associations of 5 local maps: 2 decisions taken back in 1 revision");
  EXPECT_TRUE(is_well_formed(svg_of(plot)));
}

TEST(AssociationFigure, LeavesOutAlternativesThatLieBelowAllThatWasEverChosen) {
  AssociationTree tree = example_associations();
  tree.nodes.push_back({4, 4, 3, -60.0, false});
  tree.nodes.push_back({4, 4, 2, -900.0, false});
  const PlotSeries others = series_of(association_plot(tree), "looked at");
  EXPECT_THAT(others.y, Contains(-60.0 + 51.125));
  EXPECT_EQ(others.y.size(), 3u) << "one branch and the gap behind it";
}

TEST(AssociationFigure, OfASearchThatTookNothingBackSaysSo) {
  AssociationTree tree = example_associations();
  tree.revisions.clear();
  tree.choices.clear();
  EXPECT_THAT(association_plot(tree).title, HasSubstr("5 local maps, none taken back"));
  EXPECT_THAT(series_of(association_plot(tree), "taken back").x, IsEmpty());
  EXPECT_TRUE(is_well_formed(svg_of(association_plot({}))));
}

}  // namespace
}  // namespace mapbed
