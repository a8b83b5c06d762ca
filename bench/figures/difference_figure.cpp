#include "bench/figures/difference_figure.h"

#include <fmt/format.h>

#include "algorithms/grid/map_builder.h"
#include "bench/figures/figure_sheet.h"
#include "bench/figures/plane_panel.h"
#include "bench/plot/map_raster.h"
#include "core/image/color_map.h"
#include "core/image/drawing.h"

namespace mapbed {
namespace {

constexpr double kCell = 0.1;  // [m] beams at 5 m are as far apart
constexpr double kLeg = 0.15;  // [m] radius of the mark of a feature
constexpr Rgb kGone{86, 180, 233};
constexpr Rgb kStood{120, 120, 120};

// In the robot's frame of the newest scan.
OccupancyMap grid_of(const KeptScan& scan, const Pose2& robot_from_local) {
  const std::vector<LaserScan> scans{scan.readings};
  return build_map(scans, {{scan.time(), robot_from_local * scan.local_from_robot}},
                   {.model = MapModel::counting, .resolution = kCell});
}

bool is_occupied(const Occupancy& cell) {
  return cell.probability > 0.25F;
}

// Walls lie on the edges of cells, and either side of them is met at times.
bool is_occupied_about(const OccupancyMap& grid, CellIndex cell) {
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (is_occupied(grid[{cell.x + dx, cell.y + dy}])) return true;
    }
  }
  return false;
}

RgbImage grid_panel(const OccupancyMap& grid, PlanePanel panel, const Pose2& robot) {
  panel.shade(kCell, [&](const Eigen::Vector2d& point) {
    const Occupancy& cell = grid[grid.cell_of(point)];
    return cell.known() ? color_of(ColorMap::gray, 1.0 - std::min(1.0F, 2.0F * cell.probability))
                        : kUnknownColor;
  });
  panel.draw_robot(robot);
  panel.draw_border();
  return panel.image();
}

void shade_difference(PlanePanel& panel, const OccupancyMap& now, const OccupancyMap& before) {
  panel.shade(kCell, [&](const Eigen::Vector2d& point) {
    const CellIndex cell = now.cell_of(point);
    if (!now[cell].known() || !before[cell].known()) return kUnknownColor;
    const bool is = is_occupied(now[cell]), was = is_occupied(before[cell]);
    if (is && !is_occupied_about(before, cell)) return kDynamicColor;
    if (was && !is_occupied_about(now, cell)) return kGone;
    return is || was ? kStood : kWhite;
  });
}

RgbImage difference_panel(const OccupancyMap& now, const OccupancyMap& before, PlanePanel panel) {
  shade_difference(panel, now, before);
  panel.draw_robot({});
  panel.draw_border();
  return panel.image();
}

Rgb color_of_feature(SeenBefore before) {
  if (before == SeenBefore::free) return kDynamicColor;
  return before == SeenBefore::same ? kStood : kWhite;
}

RgbImage features_panel(const PeopleMoment& moment, PlanePanel panel) {
  panel.draw_hits(moment.found.view.scan(), {}, {185, 185, 185});
  const Pose2 robot_from_local = inverse(moment.found.local_from_robot);
  for (const Eigen::Vector2d& person : moment.truth) {
    panel.draw_ring(robot_from_local * person, 0.35, kTruthColor, false);
  }
  for (std::size_t j = 0; j < moment.found.features.size(); ++j) {
    const Eigen::Vector2d& place = moment.found.features[j].position;
    fill_disc(panel.image(), panel.pixel_of(place), kLeg * panel.pixels_per_meter(),
              color_of_feature(moment.found.past.verdict(moment.found.places[j])));
    panel.draw_ring(place, kLeg, kScanColor, false);
  }
  panel.draw_robot({});
  panel.draw_border();
  return panel.image();
}

}  // namespace

RgbImage difference_figure(const std::vector<PeopleMoment>& moments, int longest_side) {
  const PeopleMoment& moment = moments.front();
  const Pose2 robot_from_local = inverse(moment.found.local_from_robot);
  const Eigen::AlignedBox2d area = area_about(moment.found.view.scan());
  const PlanePanel empty(area, 0.5 * longest_side / area.sizes().x());
  const KeptScan newest{moment.found.view.scan(), moment.found.local_from_robot};
  const KeptScan& earlier = moment.before ? *moment.before : newest;
  const OccupancyMap now = grid_of(newest, robot_from_local);
  const OccupancyMap before = grid_of(earlier, robot_from_local);
  using Kind = LegendItem::Kind;
  std::vector<LegendItem> legend{{Kind::area, kDynamicColor, "occupied, was free; moved"},
                                 {Kind::area, kGone, "free, was occupied"},
                                 {Kind::area, kStood, "occupied as before; stood"},
                                 {Kind::area, kWhite, "free; not seen before"},
                                 {Kind::area, kUnknownColor, "unknown to one of them"}};
  if (!moment.truth.empty()) legend.push_back({Kind::line, kTruthColor, "people in truth"});
  const double ago = moment.found.time() - earlier.time();
  return sheet_of(
      {{grid_panel(now, empty, {}), fmt::format("grid of the scan after {:.1f} s", moment.seconds)},
       {grid_panel(before, empty, robot_from_local * earlier.local_from_robot),
        fmt::format("of one {:.1f} s before, matched", ago)},
       {difference_panel(now, before, empty), "what differs"},
       {features_panel(moment, empty), "features, by the last seconds' scans"}},
      2, empty.pixels_per_meter(), legend);
}

}  // namespace mapbed
