#include "bench/plot/map_picture.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "algorithms/scan/scans_on_path.h"
#include "bench/plot/map_legend.h"
#include "bench/plot/map_raster.h"
#include "bench/plot/track_style.h"
#include "core/image/color_map.h"
#include "core/image/drawing.h"

namespace mapbed {
namespace {

constexpr double kFarTimes = 10.0;    // of the map's longer side: poses beyond are not shown
constexpr double kFarLeast = 1000.0;  // [m] but those that are nearer than this
constexpr int kMargin = 24;           // [pixels] around everything
constexpr int kMinWidth = 420;        // [pixels] of the map's part, so that the legend has room

// From the map to the picture: `cells_per_pixel` is 1 where `pixels_per_cell` is more than 1.
struct Layout {
  CellBox box;
  int cells_per_pixel = 1;
  int pixels_per_cell = 1;
  int blocks_x = 0, blocks_y = 0;  // of cells_per_pixel cells each way

  int width() const { return blocks_x * pixels_per_cell; }
  int height() const { return blocks_y * pixels_per_cell; }
};

// What of the paths is shown: poses that are numbers and not so far from the map, or else from the
// first pose, that both cannot be seen in one picture.
class Reach {
 public:
  Reach(const OccupancyMap& map, const CellBox& box, const std::vector<DrawnPath>& paths) {
    if (!box.empty()) {
      center_ = 0.5 * (map.frame().corner_of(box.min) + map.frame().corner_of(box.max));
      const double side = std::max(box.width(), box.height()) * map.resolution();
      farthest_ = std::max(kFarLeast, kFarTimes * side);
      return;
    }
    for (const DrawnPath& path : paths) {
      for (const Stamped<Pose2>& stamped : path.map_from_robot) {
        const Eigen::Vector2d place = stamped.pose.position();
        if (!(place.cwiseAbs().maxCoeff() < kFarLeast)) continue;
        center_ = place;
        return;
      }
    }
  }

  bool shows(const Eigen::Vector2d& place) const {
    return (place - center_).cwiseAbs().maxCoeff() <= farthest_;  // false for NaN
  }
  int not_shown(const DrawnPath& path) const {
    return static_cast<int>(
        std::count_if(path.map_from_robot.begin(), path.map_from_robot.end(),
                      [this](const auto& stamped) { return !shows(stamped.pose.position()); }));
  }

 private:
  Eigen::Vector2d center_ = Eigen::Vector2d::Zero();  // [m]
  double farthest_ = kFarLeast;                       // [m] in x and in y
};

CellBox box_around(const OccupancyMap& map, CellBox box, const std::vector<DrawnPath>& paths,
                   const Reach& reach) {
  for (const DrawnPath& path : paths) {
    for (const Stamped<Pose2>& stamped : path.map_from_robot) {
      if (!reach.shows(stamped.pose.position())) continue;
      const CellIndex cell = map.cell_of(stamped.pose.position());
      if (box.empty()) box = {cell, cell};
      box.min = {std::min(box.min.x, cell.x), std::min(box.min.y, cell.y)};
      box.max = {std::max(box.max.x, cell.x), std::max(box.max.y, cell.y)};
    }
  }
  return box.empty() ? CellBox{{0, 0}, {0, 0}} : box;
}

Layout layout_of(const CellBox& box, int longest_side) {
  Layout layout{.box = box};
  const int cells = std::max(box.width(), box.height());
  layout.cells_per_pixel = (cells + longest_side - 1) / longest_side;
  constexpr int largest_cell = 12;  // [pixels] small maps need not fill the picture
  layout.pixels_per_cell = std::clamp(longest_side / cells, 1, largest_cell);
  layout.blocks_x = (box.width() + layout.cells_per_pixel - 1) / layout.cells_per_pixel;
  layout.blocks_y = (box.height() + layout.cells_per_pixel - 1) / layout.cells_per_pixel;
  return layout;
}

Eigen::Vector2d pixel_of(const Eigen::Vector2d& point, const OccupancyMap& map,
                         const Layout& layout) {
  const Eigen::Vector2d cells = map.frame().in_cells(point);
  const double scale = static_cast<double>(layout.pixels_per_cell) / layout.cells_per_pixel;
  return {kMargin + (cells.x() - layout.box.min.x) * scale,
          kMargin + (layout.box.max.y + 1 - cells.y()) * scale};
}

// 0 is black, as walls are; 1 is orange, as points may be.
Rgb color_of_path(std::size_t path, const DrawnPoints& points) {
  return categorical_color(static_cast<int>(path) + (points.points.empty() ? 1 : 2));
}

bool is_left_out(const DrawnPath& path, double time) {
  return std::any_of(path.left_out.begin(), path.left_out.end(), [time](const TimeInterval& when) {
    return time >= when.from && time <= when.to;
  });
}

// Where the path leaves what is shown, it breaks off.
void draw_path(RgbImage& image, const DrawnPath& path, const Rgb& color, double width,
               const OccupancyMap& map, const Layout& layout, const Reach& reach) {
  const Pen pen{.color = color, .width = width, .opacity = 0.9};
  std::vector<std::vector<Eigen::Vector2d>> pieces(1);
  for (const Stamped<Pose2>& stamped : path.map_from_robot) {
    if (reach.shows(stamped.pose.position()) && !is_left_out(path, stamped.time)) {
      pieces.back().push_back(pixel_of(stamped.pose.position(), map, layout));
    } else if (!pieces.back().empty()) {
      pieces.emplace_back();
    }
  }
  for (const auto& piece : pieces) draw_polyline(image, piece, pen);
  if (pieces.front().empty()) return;
  fill_disc(image, pieces.front().front(), 6.5, kWhite);
  fill_disc(image, pieces.front().front(), 5.0, kBlack);
}

void draw_points(RgbImage& image, const DrawnPoints& points, const OccupancyMap& map,
                 const Layout& layout) {
  const int side = layout.pixels_per_cell;
  for (const Eigen::Vector2d& point : points.points) {
    if (!layout.box.contains(map.cell_of(point))) continue;
    const Eigen::Vector2d corner = pixel_of(point, map, layout);
    const int x = static_cast<int>(corner.x()) - (static_cast<int>(corner.x()) - kMargin) % side;
    const int y = static_cast<int>(corner.y()) - (static_cast<int>(corner.y()) - kMargin) % side;
    for (int dy = 0; dy < side; ++dy) {
      for (int dx = 0; dx < side; ++dx) image.at(x + dx, y + dy) = kDynamicColor;
    }
  }
}

void draw_track(RgbImage& image, const ObjectTrack& track, const OccupancyMap& map,
                const Layout& layout, const Reach& reach) {
  const Rgb color = track_color(track.id);
  std::optional<Eigen::Vector2d> last;
  for (const TrackState& state : track.states) {
    if (!reach.shows(state.position) || !layout.box.contains(map.cell_of(state.position))) {
      last.reset();
      continue;
    }
    const Eigen::Vector2d place = pixel_of(state.position, map, layout);
    const double opacity = state.occluded ? 0.3 : 1.0;
    if (last) draw_line(image, *last, place, {.color = color, .width = 1.6, .opacity = opacity});
    last = place;
  }
  if (!last) return;
  draw_text(image, *last + Eigen::Vector2d(4.0, -4.0), std::to_string(track.id),
            {.size = 13.0, .color = color, .halo = 2.0});
}

std::vector<LegendItem> legend_of(const std::vector<DrawnPath>& paths, const DrawnPoints& points,
                                  const Tracks& tracks, const Reach& reach) {
  std::vector<LegendItem> items;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const int far = reach.not_shown(paths[i]);
    const std::string remark = far > 0 ? fmt::format(" ({} poses are far outside)", far) : "";
    items.push_back({LegendItem::Kind::line, color_of_path(i, points), paths[i].name + remark});
  }
  if (!paths.empty()) items.push_back({LegendItem::Kind::disc, kBlack, "start"});
  if (!points.points.empty()) {
    items.push_back({LegendItem::Kind::area, kDynamicColor, points.name});
  }
  if (!tracks.empty()) {
    items.push_back({LegendItem::Kind::line, kTrackColors[0], "followed (faint: not seen)"});
  }
  for (LegendItem& item : legend_of_cells()) items.push_back(std::move(item));
  return items;
}

}  // namespace

RgbImage picture_of(const OccupancyMap& map, const std::vector<DrawnPath>& paths,
                    const PictureOptions& options, const DrawnPoints& points,
                    const Tracks& tracks) {
  const CellBox surroundings = box_of_surroundings(map);
  const Reach reach(map, surroundings, paths);
  const Layout layout =
      layout_of(box_around(map, surroundings, paths, reach), options.longest_side);
  const int width = std::max(layout.width(), kMinWidth);
  const std::vector<LegendItem> items = legend_of(paths, points, tracks, reach);
  const int legend_height = (legend_rows(items, width) + 1) * kLegendRow;

  RgbImage image(width + 2 * kMargin, layout.height() + 3 * kMargin + legend_height, kWhite);
  paste(image_of_cells(map, layout.box, layout.cells_per_pixel), layout.pixels_per_cell, image,
        kMargin, kMargin);
  draw_points(image, points, map, layout);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const double line = 1.8 + 2.4 * static_cast<double>(paths.size() - 1 - i);
    draw_path(image, paths[i], color_of_path(i, points), line, map, layout, reach);
  }
  for (const ObjectTrack& track : tracks) draw_track(image, track, map, layout, reach);

  const Eigen::Vector2d below(kMargin, layout.height() + 2 * kMargin + kLegendRow / 2);
  const double pixels_per_meter =
      layout.pixels_per_cell / (layout.cells_per_pixel * map.resolution());
  draw_scale_bar(image, below, pixels_per_meter, width);
  draw_legend(image, items, below + Eigen::Vector2d(0, kLegendRow), width);
  return image;
}

DrawnPoints dynamic_points(const SensorLog& log, const Trajectory& map_from_robot,
                           std::span<const ScanLabels> labels, const BeamLimits& limits) {
  DrawnPoints drawn{.name = "met what moves"};
  if (labels.empty()) return drawn;
  auto next = labels.begin();
  for_each_scan_on_path(log, map_from_robot, [&](const LaserScan& scan, const Pose2& pose) {
    const ScanLabels& of_scan = *next++;
    for_each_beam(scan, pose, limits, [&](std::size_t n, const Beam& beam) {
      if (beam.hit && is_dynamic(of_scan, n)) drawn.points.push_back(beam.end);
    });
  });
  return drawn;
}

}  // namespace mapbed
