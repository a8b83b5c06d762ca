#include "bench/figures/figure_sheet.h"

#include <algorithm>

#include "core/check.h"
#include "core/image/drawing.h"

namespace mapbed {
namespace {

constexpr int kMargin = 24;  // [pixels] around everything and between panels

// Of the rows, and below them.
std::vector<int> row_tops(const std::vector<FigurePanel>& panels, int columns) {
  std::vector<int> tops{kMargin};
  for (std::size_t begin = 0; begin < panels.size(); begin += static_cast<std::size_t>(columns)) {
    int highest = 0;
    const std::size_t end = std::min(begin + static_cast<std::size_t>(columns), panels.size());
    for (std::size_t i = begin; i < end; ++i) highest = std::max(highest, panels[i].image.height());
    tops.push_back(tops.back() + highest + kLegendRow + kMargin / 2);
  }
  return tops;
}

void draw_panel(RgbImage& sheet, const FigurePanel& panel, std::size_t number, int x, int y) {
  paste(panel.image, 1, sheet, x, y);
  const std::string letter(1, static_cast<char>('a' + number));
  draw_text(sheet, Eigen::Vector2d(x, y + panel.image.height() + kLegendRow - 8),
            letter + "  " + panel.caption, {.size = kLegendTextSize});
}

}  // namespace

RgbImage sheet_of(const std::vector<FigurePanel>& panels, int columns, double pixels_per_meter,
                  const std::vector<LegendItem>& legend) {
  CHECK(!panels.empty() && columns > 0);
  int widest = 0;
  for (const FigurePanel& panel : panels) widest = std::max(widest, panel.image.width());
  columns = std::min(columns, static_cast<int>(panels.size()));
  const int width = columns * widest + (columns - 1) * kMargin;
  const std::vector<int> tops = row_tops(panels, columns);
  const int below = (legend_rows(legend, width) + 1) * kLegendRow;
  RgbImage sheet(width + 2 * kMargin, tops.back() + below + kMargin, kWhite);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const auto [row, column] = std::div(static_cast<int>(i), columns);
    draw_panel(sheet, panels[i], i, kMargin + column * (widest + kMargin),
               tops[static_cast<std::size_t>(row)]);
  }
  const Eigen::Vector2d corner(kMargin, tops.back() + kLegendRow / 2);
  draw_scale_bar(sheet, corner, pixels_per_meter, widest);
  draw_legend(sheet, legend, corner + Eigen::Vector2d(0, kLegendRow), width);
  return sheet;
}

}  // namespace mapbed
