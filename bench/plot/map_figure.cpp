#include "bench/plot/map_figure.h"

#include <algorithm>
#include <cmath>

#include "bench/plot/map_legend.h"
#include "bench/plot/map_raster.h"
#include "core/check.h"
#include "core/image/drawing.h"

namespace mapbed {
namespace {

constexpr int kMargin = 24;       // [pixels] around everything and between maps
constexpr int kMinWidth = 420;    // [pixels] so that the legend has room
constexpr int kLargestCell = 12;  // [pixels] small maps need not fill the figure

// A map and its place in the figure.
struct Panel {
  const NamedMap* of = nullptr;
  CellBox box;
  int cells_per_block = 1;    // that are drawn as one
  double block = 0.0;         // [m]
  int x = 0, y = 0;           // [pixels] top left corner
  int width = 0, height = 0;  // [pixels] of the map

  double resolution() const { return of->map.resolution(); }
  double meters_wide() const { return box.width() * resolution(); }
  double meters_high() const { return box.height() * resolution(); }
  int name_width() const {
    return static_cast<int>(std::ceil(text_width(of->name, kLegendTextSize)));
  }
};

// [m] that the longest row is wide or all rows are high.
double longest(const std::vector<Panel>& panels, std::size_t in_row) {
  double widest = 0.0, height = 0.0;
  for (std::size_t begin = 0; begin < panels.size(); begin += in_row) {
    double width = 0.0, highest = 0.0;
    for (std::size_t i = begin; i < std::min(begin + in_row, panels.size()); ++i) {
      width += panels[i].meters_wide();
      highest = std::max(highest, panels[i].meters_high());
    }
    widest = std::max(widest, width);
    height += highest;
  }
  return std::max(widest, height);
}

// As many as let the maps be largest; of several such numbers the most.
std::size_t panels_in_row(const std::vector<Panel>& panels) {
  std::size_t best = panels.size();
  for (std::size_t in_row = panels.size(); in_row >= 1; --in_row) {
    if (longest(panels, in_row) < longest(panels, best) - 1e-9) best = in_row;
  }
  return best;
}

// Chooses what each map draws as one block: a cell, or as many as there are in a pixel, so that no
// thin wall falls between two pixels. Gives the metres of a pixel, the same for all; the finest
// blocks are a whole number of pixels.
double choose_scale(std::vector<Panel>& panels, double least) {
  double finest = HUGE_VAL;
  for (Panel& panel : panels) {
    panel.cells_per_block =
        std::max(1, static_cast<int>(std::ceil(least / panel.resolution() - 1e-9)));
    panel.block = panel.cells_per_block * panel.resolution();
    finest = std::min(finest, panel.block);
  }
  return finest / std::clamp(std::floor(finest / least + 1e-9), 1.0, double{kLargestCell});
}

int pixels(double meters, double of_pixel) {
  return std::max(1, static_cast<int>(std::lround(meters / of_pixel)));
}

// Row by row; gives the size of what they take with the margin around.
struct Size {
  int width = 0, height = 0;
};
Size place(std::vector<Panel>& panels, std::size_t in_row, double of_pixel) {
  Size size{2 * kMargin + kMinWidth, kMargin};
  for (std::size_t begin = 0; begin < panels.size(); begin += in_row) {
    int x = kMargin, highest = 0;
    for (std::size_t i = begin; i < std::min(begin + in_row, panels.size()); ++i) {
      Panel& panel = panels[i];
      const double blocks_x = std::ceil(1.0 * panel.box.width() / panel.cells_per_block);
      const double blocks_y = std::ceil(1.0 * panel.box.height() / panel.cells_per_block);
      panel.width = pixels(blocks_x * panel.block, of_pixel);
      panel.height = pixels(blocks_y * panel.block, of_pixel);
      panel.x = x;
      panel.y = size.height + kLegendRow;
      x += std::max(panel.width, panel.name_width()) + kMargin;
      highest = std::max(highest, panel.height);
    }
    size.width = std::max(size.width, x);
    size.height += kLegendRow + highest + kMargin;
  }
  return size;
}

// A block of the map wide.
void draw_dynamic(RgbImage& figure, const Panel& panel, int blocks_x, int blocks_y) {
  for (const Eigen::Vector2d& point : panel.of->dynamic.points) {
    const CellIndex cell = panel.of->map.cell_of(point);
    if (!panel.box.contains(cell)) continue;
    const int x = (cell.x - panel.box.min.x) / panel.cells_per_block;
    const int y = (panel.box.max.y - cell.y) / panel.cells_per_block;
    const auto edge = [](int block, int blocks, int pixels) {
      return (block * pixels + blocks - 1) / blocks;
    };
    for (int py = edge(y, blocks_y, panel.height); py < edge(y + 1, blocks_y, panel.height); ++py) {
      for (int px = edge(x, blocks_x, panel.width); px < edge(x + 1, blocks_x, panel.width); ++px) {
        figure.at(panel.x + px, panel.y + py) = kDynamicColor;
      }
    }
  }
}

void draw(RgbImage& figure, const Panel& panel) {
  const RgbImage blocks = image_of_cells(panel.of->map, panel.box, panel.cells_per_block);
  for (int y = 0; y < panel.height; ++y) {
    const int from_y = y * blocks.height() / panel.height;
    for (int x = 0; x < panel.width; ++x) {
      figure.at(panel.x + x, panel.y + y) = blocks.at(x * blocks.width() / panel.width, from_y);
    }
  }
  draw_dynamic(figure, panel, blocks.width(), blocks.height());
  draw_text(figure, Eigen::Vector2d(panel.x, panel.y - 8), panel.of->name,
            {.size = kLegendTextSize});
}

}  // namespace

RgbImage figure_of(const std::vector<NamedMap>& maps, int longest_side) {
  CHECK(!maps.empty() && longest_side > 0);
  std::vector<Panel> panels;
  for (const NamedMap& map : maps) {
    CellBox box = box_of_surroundings(map.map);
    if (box.empty()) box = {{0, 0}, {0, 0}};
    panels.push_back({.of = &map, .box = box});
  }
  const std::size_t in_row = panels_in_row(panels);
  const double of_pixel = choose_scale(panels, longest(panels, in_row) / longest_side);
  const Size size = place(panels, in_row, of_pixel);
  std::vector<LegendItem> legend = legend_of_cells();
  for (const NamedMap& map : maps) {
    if (map.dynamic.points.empty()) continue;
    legend.push_back({LegendItem::Kind::area, kDynamicColor, map.dynamic.name});
    break;
  }
  const double width = size.width - 2 * kMargin;
  const int below = (legend_rows(legend, width) + 1) * kLegendRow;
  RgbImage figure(size.width, size.height + below, kWhite);
  for (const Panel& panel : panels) draw(figure, panel);
  const Eigen::Vector2d corner(kMargin, size.height + kLegendRow / 2 - kMargin / 2);
  draw_scale_bar(figure, corner, 1.0 / of_pixel, width);
  draw_legend(figure, legend, corner + Eigen::Vector2d(0, kLegendRow), width);
  return figure;
}

}  // namespace mapbed
