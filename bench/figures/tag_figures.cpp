#include "bench/figures/tag_figures.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "bench/figures/figure_sheet.h"
#include "bench/figures/plane_panel.h"
#include "bench/plot/map_raster.h"
#include "core/image/color_map.h"
#include "core/image/drawing.h"

namespace mapbed {
namespace {

using Kind = LegendItem::Kind;

constexpr Rgb kTrueTag{0, 158, 115};
constexpr Rgb kMappedTag{213, 94, 0};
constexpr Rgb kLeft{0, 114, 178};
constexpr Rgb kRight{230, 159, 0};
constexpr double kMapSide = 900.0;    // [px]
constexpr double kPanelSide = 300.0;  // [px]

void draw_cross(PlanePanel& panel, const Eigen::Vector2d& at, const Rgb& color) {
  const Eigen::Vector2d middle = panel.pixel_of(at);
  const Pen pen{.color = color, .width = 2.5};
  draw_line(panel.image(), middle + Eigen::Vector2d(-6.0, -6.0), middle + Eigen::Vector2d(6.0, 6.0),
            pen);
  draw_line(panel.image(), middle + Eigen::Vector2d(-6.0, 6.0), middle + Eigen::Vector2d(6.0, -6.0),
            pen);
}

Eigen::AlignedBox2d area_of(const std::vector<BeliefMoment>& moments) {
  Eigen::AlignedBox2d area;
  for (const BeliefMoment& moment : moments) {
    for (const Eigen::Vector2d& position : moment.belief.positions) area.extend(position);
    area.extend(moment.robot);
  }
  const Eigen::Vector2d room(0.5, 0.5);
  return {area.min() - room, area.max() + room};
}

PlanePanel belief_panel(const BeliefMoment& moment, const Eigen::Vector2d& truth,
                        PlanePanel panel) {
  const std::vector<double>& weights = moment.belief.weights;
  const double most = *std::max_element(weights.begin(), weights.end());
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double radius = 4.0 * weights[i] / most;
    if (radius < 0.3) continue;
    fill_disc(panel.image(), panel.pixel_of(moment.belief.positions[i]), radius, kMappedTag, 0.7);
  }
  draw_cross(panel, truth, kTrueTag);
  fill_disc(panel.image(), panel.pixel_of(moment.robot), 5.0, kRobotColor);
  panel.draw_border();
  return panel;
}

PlanePanel map_panel(const OccupancyMap& map) {
  const CellBox box = box_of_surroundings(map);
  const Eigen::Vector2d low = map.frame().corner_of({box.min.x, box.min.y});
  const Eigen::Vector2d size = map.resolution() * Eigen::Vector2d(box.width(), box.height());
  PlanePanel panel(Eigen::AlignedBox2d(low, low + size), kMapSide / size.maxCoeff());
  panel.shade(map.resolution(), [&](const Eigen::Vector2d& point) {
    const Occupancy& cell = map[map.cell_of(point)];
    return cell.known() ? color_of(ColorMap::gray, 1.0 - static_cast<double>(cell.probability))
                        : kUnknownColor;
  });
  return panel;
}

}  // namespace

RgbImage belief_figure(const std::vector<BeliefMoment>& moments, const Eigen::Vector2d& truth) {
  const Eigen::AlignedBox2d area = area_of(moments);
  const PlanePanel empty(area, kPanelSide / area.sizes().maxCoeff());
  std::vector<FigurePanel> panels;
  for (const BeliefMoment& moment : moments) {
    panels.push_back(
        {belief_panel(moment, truth, empty).image(),
         fmt::format("{} detection{}", moment.detections, moment.detections == 1 ? "" : "s")});
  }
  return sheet_of(panels, 3, empty.pixels_per_meter(),
                  {{Kind::disc, kMappedTag, "positions, as wide as they weigh"},
                   {Kind::disc, kTrueTag, "the tag in truth"},
                   {Kind::disc, kRobotColor, "the robot"}});
}

RgbImage tag_map_figure(const OccupancyMap& map, const std::vector<MappedTag>& tags) {
  PlanePanel panel = map_panel(map);
  for (const MappedTag& tag : tags) {
    panel.draw_path({tag.truth, tag.mapped}, kMappedTag);
    draw_cross(panel, tag.truth, kTrueTag);
    fill_disc(panel.image(), panel.pixel_of(tag.mapped), 4.0, kMappedTag);
  }
  return sheet_of({{panel.image(), "tags"}}, 1, panel.pixels_per_meter(),
                  {{Kind::disc, kMappedTag, "mapped"}, {Kind::disc, kTrueTag, "in truth"}});
}

RgbImage heard_from_figure(const OccupancyMap& map, const std::vector<Eigen::Vector2d>& left,
                           const std::vector<Eigen::Vector2d>& right, const Eigen::Vector2d& tag) {
  PlanePanel panel = map_panel(map);
  for (const Eigen::Vector2d& place : left) {
    fill_disc(panel.image(), panel.pixel_of(place), 3.5, kLeft, 0.6);
  }
  for (const Eigen::Vector2d& place : right) {
    fill_disc(panel.image(), panel.pixel_of(place), 2.0, kRight, 0.8);
  }
  draw_cross(panel, tag, kTrueTag);
  return sheet_of({{panel.image(), "where one tag was heard"}}, 1, panel.pixels_per_meter(),
                  {{Kind::disc, kLeft, "by the left antenna"},
                   {Kind::disc, kRight, "by the right antenna"},
                   {Kind::disc, kTrueTag, "the tag"}});
}

}  // namespace mapbed
