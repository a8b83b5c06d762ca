#include "bench/plot/map_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include <fmt/format.h>

#include "core/image/color_map.h"
#include "core/image/drawing.h"

namespace mapbed {
namespace {

constexpr Rgb kUnknown{205, 214, 224};
// Half of the beams of a thin wall end in the cell before or behind it, or pass at its edges.
constexpr float kBlackFrom = 0.5F;
constexpr double kStrayLength = 1.0;     // [m]
constexpr double kStrayFraction = 0.02;  // of the known cells, at each side
constexpr double kStrayBorder = 0.5;     // [m]
constexpr double kFarTimes = 10.0;       // of the map's longer side: poses beyond are not shown
constexpr double kFarLeast = 1000.0;     // [m] but those that are nearer than this
constexpr int kMargin = 24;              // [pixels] around everything
constexpr int kMinWidth = 420;           // [pixels] of the map's part, so that the legend has room
constexpr double kTextSize = 15.0;       // [pixels]
constexpr int kRowHeight = 26;           // [pixels] of the legend
constexpr double kSample = 28.0;         // [pixels] length of a sample in the legend

// From the map to the picture: `cells_per_pixel` is 1 where `pixels_per_cell` is more than 1.
struct Layout {
  CellBox box;
  int cells_per_pixel = 1;
  int pixels_per_cell = 1;
  int blocks_x = 0, blocks_y = 0;  // of cells_per_pixel cells each way

  int width() const { return blocks_x * pixels_per_cell; }
  int height() const { return blocks_y * pixels_per_cell; }
};

// How many cells at either end of `known_cells`, counted by row or by column, hold no more than
// stray beams: less than kStrayLength known in each and all together less than kStrayFraction of
// the map. Some of them stay as a border.
struct Trim {
  int low = 0, high = 0;
};

Trim stray_ends(const std::vector<int>& known_cells, double resolution) {
  const double few = kStrayLength / resolution;
  const auto all = std::accumulate(known_cells.begin(), known_cells.end(), std::int64_t{0});
  const double allowed = kStrayFraction * static_cast<double>(all);
  const int border = static_cast<int>(kStrayBorder / resolution);
  const auto count_from = [&](auto first, auto last) {
    int count = 0;
    std::int64_t left_out = 0;
    for (auto at = first; at != last && *at < few; ++at, ++count) {
      left_out += *at;
      if (static_cast<double>(left_out) > allowed) break;
    }
    return std::max(0, count - border);
  };
  return {count_from(known_cells.begin(), known_cells.end()),
          count_from(known_cells.rbegin(), known_cells.rend())};
}

// The box of what is known, without the far ends of stray beams: a few that went out of a window
// would shrink the building to a corner.
CellBox box_of_surroundings(const OccupancyMap& map) {
  CellBox box = known_box(map);
  if (box.empty()) return box;
  std::vector<int> in_column(static_cast<std::size_t>(box.width()));
  std::vector<int> in_row(static_cast<std::size_t>(box.height()));
  map.for_each([&](CellIndex cell, const Occupancy& occupancy) {
    if (!occupancy.known()) return;
    ++in_column[static_cast<std::size_t>(cell.x - box.min.x)];
    ++in_row[static_cast<std::size_t>(cell.y - box.min.y)];
  });
  const Trim x = stray_ends(in_column, map.resolution());
  const Trim y = stray_ends(in_row, map.resolution());
  return {{box.min.x + x.low, box.min.y + y.low}, {box.max.x - x.high, box.max.y - y.high}};
}

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

// What is known of the cells that share a pixel.
struct Block {
  float sum = 0.0F;
  float largest = 0.0F;
  int known = 0;

  // Between mean and maximum: walls stay visible, and speckles do not become walls.
  Rgb color() const {
    if (known == 0) return kUnknown;
    const float occupied = 0.5F * (sum / static_cast<float>(known) + largest);
    return color_of(ColorMap::gray, 1.0 - std::min(1.0F, occupied / kBlackFrom));
  }
};

RgbImage image_of_blocks(const OccupancyMap& map, const Layout& layout) {
  std::vector<Block> blocks(static_cast<std::size_t>(layout.blocks_x) *
                            static_cast<std::size_t>(layout.blocks_y));
  map.for_each([&](CellIndex cell, const Occupancy& occupancy) {
    if (!occupancy.known() || !layout.box.contains(cell)) return;
    const int x = (cell.x - layout.box.min.x) / layout.cells_per_pixel;
    const int y = (layout.box.max.y - cell.y) / layout.cells_per_pixel;  // the picture's y is down
    Block& block = blocks[static_cast<std::size_t>(y) * static_cast<std::size_t>(layout.blocks_x) +
                          static_cast<std::size_t>(x)];
    block.sum += occupancy.probability;
    block.largest = std::max(block.largest, occupancy.probability);
    ++block.known;
  });
  RgbImage image(layout.blocks_x, layout.blocks_y);
  std::transform(blocks.begin(), blocks.end(), image.pixels().begin(),
                 [](const Block& block) { return block.color(); });
  return image;
}

Eigen::Vector2d pixel_of(const Eigen::Vector2d& point, const OccupancyMap& map,
                         const Layout& layout) {
  const Eigen::Vector2d cells = map.frame().in_cells(point);
  const double scale = static_cast<double>(layout.pixels_per_cell) / layout.cells_per_pixel;
  return {kMargin + (cells.x() - layout.box.min.x) * scale,
          kMargin + (layout.box.max.y + 1 - cells.y()) * scale};
}

Rgb color_of_path(std::size_t path) {
  return categorical_color(static_cast<int>(path) + 1);  // 0 is black, as walls are
}

// Where the path leaves what is shown, it breaks off.
void draw_path(RgbImage& image, const DrawnPath& path, const Rgb& color, double width,
               const OccupancyMap& map, const Layout& layout, const Reach& reach) {
  const Pen pen{.color = color, .width = width, .opacity = 0.9};
  std::vector<std::vector<Eigen::Vector2d>> pieces(1);
  for (const Stamped<Pose2>& stamped : path.map_from_robot) {
    if (reach.shows(stamped.pose.position())) {
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

// The largest of 1, 2, 5, 10, … m that is at most `longest` metres.
double round_length(double longest) {
  const double power = std::pow(10.0, std::floor(std::log10(longest)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= longest) return factor * power;
  }
  return power;
}

std::string length_text(double meters) {
  return meters < 1.0 ? fmt::format("{:g} cm", 100.0 * meters) : fmt::format("{:g} m", meters);
}

void draw_scale_bar(RgbImage& image, const Eigen::Vector2d& left, double length, double pixels) {
  const Pen pen{.color = kBlack, .width = 2.0};
  const Eigen::Vector2d right = left + Eigen::Vector2d(pixels, 0.0);
  draw_line(image, left, right, pen);
  for (const Eigen::Vector2d& end : {left, right}) {
    draw_line(image, end - Eigen::Vector2d(0, 5), end + Eigen::Vector2d(0, 5), pen);
  }
  draw_text(image, right + Eigen::Vector2d(10, 5), length_text(length), {.size = kTextSize});
}

// A sample and what it means.
struct LegendItem {
  enum class Kind { line, disc, area } kind;
  Rgb color;
  std::string text;

  double width() const { return kSample + 8 + text_width(text, kTextSize) + 26; }
};

std::vector<LegendItem> legend_of(const std::vector<DrawnPath>& paths, const Reach& reach) {
  std::vector<LegendItem> items;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const int far = reach.not_shown(paths[i]);
    const std::string remark = far > 0 ? fmt::format(" ({} poses are far outside)", far) : "";
    items.push_back({LegendItem::Kind::line, color_of_path(i), paths[i].name + remark});
  }
  if (!paths.empty()) items.push_back({LegendItem::Kind::disc, kBlack, "start"});
  items.push_back({LegendItem::Kind::area, kBlack, "occupied"});
  items.push_back({LegendItem::Kind::area, kWhite, "free"});
  items.push_back({LegendItem::Kind::area, kUnknown, "unknown"});
  return items;
}

void draw_item(RgbImage& image, const LegendItem& item, const Eigen::Vector2d& middle_left) {
  const Eigen::Vector2d right = middle_left + Eigen::Vector2d(kSample, 0);
  if (item.kind == LegendItem::Kind::line) {
    draw_line(image, middle_left, right, {.color = item.color, .width = 3.0});
  } else if (item.kind == LegendItem::Kind::disc) {
    fill_disc(image, (middle_left + right) / 2, 5.0, item.color);
  } else {
    const Eigen::Vector2d half(0, 7);
    const Eigen::Vector2d edge(1, 1);
    fill_rectangle(image, middle_left - half, right + half, {120, 120, 120});
    fill_rectangle(image, middle_left - half + edge, right + half - edge, item.color);
  }
  draw_text(image, right + Eigen::Vector2d(8, 5), item.text, {.size = kTextSize});
}

// Where each item of the legend begins, left to right in as many rows as needed.
std::vector<Eigen::Vector2d> places_of(const std::vector<LegendItem>& items, double width) {
  std::vector<Eigen::Vector2d> places;
  double x = 0.0;
  double y = 0.0;
  for (const LegendItem& item : items) {
    if (x > 0.0 && x + item.width() > width) {
      x = 0.0;
      y += kRowHeight;
    }
    places.emplace_back(x, y);
    x += item.width();
  }
  return places;
}

}  // namespace

RgbImage picture_of(const OccupancyMap& map, const std::vector<DrawnPath>& paths,
                    const PictureOptions& options) {
  const CellBox surroundings = box_of_surroundings(map);
  const Reach reach(map, surroundings, paths);
  const Layout layout =
      layout_of(box_around(map, surroundings, paths, reach), options.longest_side);
  const int width = std::max(layout.width(), kMinWidth);
  const std::vector<LegendItem> items = legend_of(paths, reach);
  const std::vector<Eigen::Vector2d> places = places_of(items, width);
  const int legend_height = static_cast<int>(places.back().y()) + 2 * kRowHeight;

  RgbImage image(width + 2 * kMargin, layout.height() + 3 * kMargin + legend_height, kWhite);
  paste(image_of_blocks(map, layout), layout.pixels_per_cell, image, kMargin, kMargin);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const double line = 1.8 + 2.4 * static_cast<double>(paths.size() - 1 - i);
    draw_path(image, paths[i], color_of_path(i), line, map, layout, reach);
  }

  const Eigen::Vector2d below(kMargin, layout.height() + 2 * kMargin + kRowHeight / 2);
  const double pixels_per_meter =
      layout.pixels_per_cell / (layout.cells_per_pixel * map.resolution());
  const double bar = round_length(0.25 * width / pixels_per_meter);
  draw_scale_bar(image, below, bar, bar * pixels_per_meter);
  for (std::size_t i = 0; i < items.size(); ++i) {
    draw_item(image, items[i], below + places[i] + Eigen::Vector2d(0, kRowHeight));
  }
  return image;
}

}  // namespace mapbed
