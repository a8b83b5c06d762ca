#include "bench/figures/scan_figure.h"

#include <cmath>

#include <fmt/format.h>

#include "algorithms/people/front_end/occlusion.h"
#include "bench/figures/figure_sheet.h"
#include "bench/figures/plane_panel.h"
#include "bench/figures/range_profile.h"
#include "bench/plot/map_raster.h"
#include "core/image/color_map.h"
#include "core/image/drawing.h"

namespace mapbed {
namespace {

constexpr double kLeg = 0.15;   // [m] radius of the mark of a feature
constexpr double kCell = 0.05;  // [m] of the occlusion grid
constexpr double kBody = 0.15;  // [m] radius of a person
constexpr Rgb kPale{185, 185, 185};

Rgb dark_where(double probability) {
  return color_of(ColorMap::gray, 1.0 - 0.85 * probability);
}

RgbImage scan_panel(const PeopleMoment& moment, PlanePanel panel) {
  const LaserScan& scan = moment.found.view.scan();
  panel.draw_area_seen(scan, {});
  const Pose2 robot_from_local = inverse(moment.found.local_from_robot);
  for (const Eigen::Vector2d& person : moment.truth) {
    panel.draw_ring(robot_from_local * person, 0.35, kTruthColor, false);
  }
  panel.draw_hits(scan, {}, kScanColor);
  for (const LegFeature& feature : moment.found.features) {
    panel.draw_ring(feature.position, kLeg, kDynamicColor, false);
  }
  panel.draw_robot({});
  panel.draw_border();
  return panel.image();
}

RgbImage quality_panel(const PeopleMoment& moment, PlanePanel panel) {
  panel.draw_hits(moment.found.view.scan(), {}, kPale);
  for (const LegFeature& feature : moment.found.features) {
    fill_disc(panel.image(), panel.pixel_of(feature.position), kLeg * panel.pixels_per_meter(),
              dark_where(feature.quality));
    panel.draw_ring(feature.position, kLeg, kScanColor, false);
  }
  panel.draw_robot({});
  panel.draw_border();
  return panel.image();
}

RgbImage occlusion_panel(const PeopleMoment& moment, const Eigen::AlignedBox2d& area,
                         PlanePanel panel) {
  const double half_side = std::max(area.max().maxCoeff(), -area.min().minCoeff());
  const OcclusionGrid grid = occlusion_grid(moment.found.view, half_side, kCell, kBody);
  panel.shade(kCell, [&](const Eigen::Vector2d& point) {
    const Eigen::Vector2d cell = (point.array() + half_side) / kCell;
    return dark_where(grid.at(std::min(static_cast<int>(cell.x()), grid.cells - 1),
                              std::min(static_cast<int>(cell.y()), grid.cells - 1)));
  });
  panel.draw_robot({});
  panel.draw_border();
  return panel.image();
}

}  // namespace

RgbImage scan_figure(const std::vector<PeopleMoment>& moments, int longest_side) {
  const PeopleMoment& moment = moments.front();
  const Eigen::AlignedBox2d area = area_about(moment.found.view.scan());
  const PlanePanel empty(area, 0.5 * longest_side / area.sizes().x());
  using Kind = LegendItem::Kind;
  std::vector<LegendItem> legend{{Kind::disc, kScanColor, "met by the laser"},
                                 {Kind::disc, kDynamicColor, "local minimum, may be a leg"},
                                 {Kind::area, dark_where(0.0), "probability 0"},
                                 {Kind::area, dark_where(1.0), "1: a leg (b), hidden (c)"}};
  if (!moment.truth.empty()) legend.push_back({Kind::line, kTruthColor, "people in truth"});
  return sheet_of(
      {{scan_panel(moment, empty), fmt::format("the scan after {:.1f} s", moment.seconds)},
       {quality_panel(moment, empty), "how much each local minimum looks like a leg"},
       {occlusion_panel(moment, area, empty), "occlusion grid: where a person is hidden"},
       {range_profile(moment.found.view, moment.found.features, empty.image().width(),
                      empty.image().height(), kDynamicColor),
        "the ranges, local minima marked"}},
      2, empty.pixels_per_meter(), legend);
}

}  // namespace mapbed
