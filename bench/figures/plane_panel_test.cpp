#include "bench/figures/plane_panel.h"

#include <algorithm>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "bench/figures/figure_sheet.h"

namespace mapbed {
namespace {

constexpr Rgb kInk{200, 0, 0};

// From (-2, -1) to (4, 3) at 10 pixels a metre.
PlanePanel panel() {
  return PlanePanel({Eigen::Vector2d(-2.0, -1.0), Eigen::Vector2d(4.0, 3.0)}, 10.0);
}

TEST(PlanePanel, HasXToTheRightAndYUp) {
  EXPECT_EQ(panel().image().width(), 60);
  EXPECT_EQ(panel().image().height(), 40);
  EXPECT_EQ(panel().pixel_of({-2.0, 3.0}), Eigen::Vector2d(0, 0));
  EXPECT_EQ(panel().pixel_of({4.0, -1.0}), Eigen::Vector2d(60, 40));
}

TEST(PlanePanel, ShadesEverySquareByItsMiddle) {
  PlanePanel drawn = panel();
  drawn.shade(0.5, [](const Eigen::Vector2d& point) { return point.x() < 0.0 ? kInk : kBlack; });
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 60; ++x) EXPECT_EQ(drawn.image().at(x, y), x < 20 ? kInk : kBlack);
  }
}

TEST(PlanePanel, DrawsHitsWhereTheBeamsEndAndNothingOfOthers) {
  // Ahead 2 m, to the left nothing, behind a beam that failed.
  const LaserScan scan{.bearing_step = M_PI / 2, .max_range = 8.0, .ranges = {2.0, 8.0, 0.0}};
  PlanePanel drawn = panel();
  drawn.draw_hits(scan, {1.0, 1.0, M_PI / 2}, kInk);  // looks up from (1, 1)
  EXPECT_NE(drawn.image().at(30, 0), kWhite) << "at (1, 3)";
  EXPECT_EQ(drawn.image().at(10, 20), kWhite) << "at (-1, 1)";
  EXPECT_EQ(drawn.image().at(30, 39), kWhite);
}

TEST(PlanePanel, AnEllipseIsAsLongAsItsSigmas) {
  PlanePanel drawn = panel();
  drawn.draw_ellipse({1.0, 1.0}, Eigen::Vector2d(4.0, 0.25).asDiagonal(), kInk, false);
  EXPECT_NE(drawn.image().at(10, 20), kWhite) << "2 m to the left";
  EXPECT_NE(drawn.image().at(30, 15), kWhite) << "0.5 m up";
  EXPECT_EQ(drawn.image().at(30, 10), kWhite);
}

TEST(PlanePanel, ShowsWhatIsBehindWhereALaserLooksThere) {
  const LaserScan ahead{.first_bearing = -1.5,
                        .bearing_step = 0.1,
                        .max_range = 8.0,
                        .ranges = std::vector<double>(31, 3.0)};
  LaserScan around = ahead;
  around.ranges.assign(63, 3.0);
  EXPECT_GT(area_about(ahead).min().x(), -3.0);
  EXPECT_DOUBLE_EQ(area_about(around).min().x(), -area_about(around).max().x());
}

TEST(FigureSheet, SetsItsPanelsBesideAndBelowEachOther) {
  const std::vector<Rgb> inks{{1, 200, 0}, {2, 200, 0}, {3, 200, 0}};  // texts are grey
  std::vector<FigurePanel> panels;
  for (const Rgb& ink : inks) panels.push_back({RgbImage(100, 50, ink), "words"});
  const RgbImage sheet = sheet_of(panels, 2, 10.0, {});
  std::vector<Eigen::AlignedBox2i> boxes(inks.size());
  for (int y = 0; y < sheet.height(); ++y) {
    for (int x = 0; x < sheet.width(); ++x) {
      const auto ink = std::find(inks.begin(), inks.end(), sheet.at(x, y));
      if (ink == inks.end()) continue;
      boxes[static_cast<std::size_t>(ink - inks.begin())].extend(Eigen::Vector2i(x, y));
    }
  }
  for (const Eigen::AlignedBox2i& box : boxes) EXPECT_EQ(box.sizes(), Eigen::Vector2i(99, 49));
  EXPECT_GT(boxes[1].min().x(), boxes[0].max().x());
  EXPECT_EQ(boxes[1].min().y(), boxes[0].min().y());
  EXPECT_EQ(boxes[2].min().x(), boxes[0].min().x());
  EXPECT_GT(boxes[2].min().y(), boxes[0].max().y());
}

}  // namespace
}  // namespace mapbed
