#include "bench/plot/matrix.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "bench/plot/plot_frame.h"
#include "bench/plot/svg_text.h"
#include "core/check.h"
#include "core/file/csv_file.h"
#include "core/image/color_map.h"

namespace mapbed {
namespace {

constexpr double kSmall = 9.5;                   // [px] size of the names
constexpr double kRow = 13.0;                    // [px] height of a cell
constexpr double kWidest = 60.0;                 // [px] of a cell
constexpr double kEdge = 10.0;                   // [px] around everything
constexpr double kBarHeight = 10.0;              // [px] of the colour scale
constexpr double kBetween = 4.0;                 // [px] between groups of columns
constexpr double kRowNames = 0.45 * kPlotWidth;  // [px] at most

void check(const Matrix& matrix) {
  CHECK(!matrix.rows.empty() && !matrix.columns.empty());
  CHECK(matrix.values.size() == matrix.rows.size() * matrix.columns.size());
  CHECK(matrix.marks.empty() || matrix.marks.size() == matrix.values.size());
}

bool begins_group(const Matrix& matrix, std::size_t column) {
  return column == 0 || matrix.columns[column].group != matrix.columns[column - 1].group;
}

// Where the cells are.
struct Grid {
  double left = 0.0, top = 0.0;  // [px]
  double cell = 0.0;             // [px] width
  std::vector<double> x;         // [px] left side of each column

  double right() const { return x.back() + cell; }
};

double widest(const std::vector<std::string>& texts) {
  double width = 0.0;
  for (const std::string& text : texts) width = std::max(width, svg_text_width(text, kSmall));
  return width;
}

Grid grid_of(const Matrix& matrix, double top) {
  Grid grid{.left = kEdge + std::min(widest(matrix.rows), kRowNames) + 6.0, .top = top};
  double groups = 0.0;
  for (std::size_t i = 1; i < matrix.columns.size(); ++i) groups += begins_group(matrix, i) ? 1 : 0;
  const double room = kPlotWidth - kEdge - grid.left - groups * kBetween;
  grid.cell = std::min(kWidest, room / static_cast<double>(matrix.columns.size()));
  double x = grid.left;
  for (std::size_t i = 0; i < matrix.columns.size(); ++i) {
    if (i > 0 && begins_group(matrix, i)) x += kBetween;
    grid.x.push_back(x);
    x += grid.cell;
  }
  return grid;
}

std::string hex_of(double fraction) {
  const Rgb color = color_of(ColorMap::blue_to_yellow, std::clamp(fraction, 0.0, 1.0));
  return fmt::format("#{:02x}{:02x}{:02x}", color.red, color.green, color.blue);
}

// The scale's ends are those of the values, where the axis does not say more.
Scale color_scale(const Matrix& matrix) {
  Scale scale{HUGE_VAL, -HUGE_VAL, matrix.value.logarithmic};
  for (const double value : matrix.values) {
    if (!std::isfinite(value) || (scale.logarithmic && value <= 0.0)) continue;
    scale.low = std::min(scale.low, value);
    scale.high = std::max(scale.high, value);
  }
  scale.low = matrix.value.low.value_or(scale.low);
  scale.high = matrix.value.high.value_or(scale.high);
  return scale.low < scale.high ? scale : scale_of(matrix.value, matrix.values);
}

double fraction_of(double value, const Scale& scale) {
  if (std::isnan(value)) return value;
  return scale.fraction(std::clamp(value, scale.low, scale.high));
}

std::string cross(double width, double height) {
  return fmt::format(
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#eee\"/><path d=\"M0 0L{0} {1}M{0} 0L0 {1}\" "
      "stroke=\"#aaa\" stroke-width=\"0.7\"/>",
      coordinate(width), coordinate(height));
}

std::string dot(double x, double y) {
  return fmt::format(
      "<circle cx=\"{}\" cy=\"{}\" r=\"2.6\" fill=\"#fff\" stroke=\"#111\" stroke-width=\"1.1\"/>",
      coordinate(x), coordinate(y));
}

// What a pointer on the cell is told.
std::string words_of(const Matrix& matrix, std::size_t row, std::size_t column, bool marked) {
  const Matrix::Column& of = matrix.columns[column];
  const double value = matrix.values[row * matrix.columns.size() + column];
  return fmt::format("{}, {}{}{}: {}{}", matrix.rows[row], of.group, of.group.empty() ? "" : ", ",
                     of.name, std::isnan(value) ? "no value" : number_text(value),
                     marked ? ", " + matrix.mark_label : "");
}

std::string cells(const Matrix& matrix, const Grid& grid, const Scale& colors) {
  std::string svg;
  for (std::size_t row = 0; row < matrix.rows.size(); ++row) {
    const double y = grid.top + kRow * static_cast<double>(row);
    for (std::size_t column = 0; column < matrix.columns.size(); ++column) {
      const std::size_t i = row * matrix.columns.size() + column;
      const double fraction = fraction_of(matrix.values[i], colors);
      const bool marked = !matrix.marks.empty() && matrix.marks[i] > 0.5;
      svg += fmt::format("<g transform=\"translate({} {})\"><title>{}</title>",
                         coordinate(grid.x[column]), coordinate(y),
                         xml_escaped(words_of(matrix, row, column, marked)));
      svg += std::isnan(fraction)
                 ? cross(grid.cell, kRow)
                 : fmt::format("<rect width=\"{}\" height=\"{}\" fill=\"{}\"/>",
                               coordinate(grid.cell), coordinate(kRow), hex_of(fraction));
      svg += (marked ? dot(grid.cell / 2, kRow / 2) : "") + "</g>\n";
    }
  }
  return svg;
}

// Names of rows at the left, of groups above, of columns below, turned.
std::string names(const Matrix& matrix, const Grid& grid) {
  std::string svg;
  for (std::size_t row = 0; row < matrix.rows.size(); ++row) {
    const double y = grid.top + kRow * (static_cast<double>(row) + 0.5) + 0.35 * kSmall;
    const double size = fitting_size(matrix.rows[row], kSmall, kRowNames);
    svg += svg_text(grid.left - 5.0, y, matrix.rows[row], {size, "end"});
  }
  const double bottom = grid.top + kRow * static_cast<double>(matrix.rows.size());
  for (std::size_t column = 0; column < matrix.columns.size(); ++column) {
    const double x = grid.x[column] + grid.cell / 2 + 0.35 * kSmall;
    const std::string turn =
        fmt::format("transform=\"rotate(-90 {} {})\"", coordinate(x), coordinate(bottom + 5.0));
    svg += svg_text(x, bottom + 5.0, matrix.columns[column].name, {kSmall, "end", turn});
    if (!begins_group(matrix, column)) continue;
    std::size_t end = column + 1;
    while (end < matrix.columns.size() && !begins_group(matrix, end)) ++end;
    const std::string& group = matrix.columns[column].group;
    const double width = grid.x[end - 1] + grid.cell - grid.x[column];
    const double size = fitting_size(group, kSmall + 1.0, width + kBetween);
    svg += svg_text(grid.x[column] + width / 2, grid.top - 5.0, group, {size, "middle"});
  }
  return svg;
}

std::string color_bar(const Matrix& matrix, const Scale& colors, double left, double y) {
  constexpr int kSteps = 60;
  const double width = std::min(220.0, kPlotWidth - 2 * kEdge - left);
  std::string svg;
  for (int i = 0; i < kSteps; ++i) {
    svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n",
                       coordinate(left + width * i / kSteps), coordinate(y),
                       coordinate(width / kSteps + 0.3), coordinate(kBarHeight),
                       hex_of((i + 0.5) / kSteps));
  }
  for (const Tick& tick : ticks_of(colors, 5)) {
    if (tick.text.empty()) continue;
    const double x = left + width * colors.fraction(tick.value);
    svg += fmt::format("<path d=\"M{} {}v4\" stroke=\"#222\"/>\n", coordinate(x),
                       coordinate(y + kBarHeight));
    svg += svg_text(x, y + kBarHeight + 5.0 + kSmall, tick.text, {kSmall, "middle"});
  }
  const double size = fitting_size(title_of(matrix.value), kSmall, left - 8.0 - kEdge);
  return svg + svg_text(left - 8.0, y + kBarHeight - 1.0, title_of(matrix.value), {size, "end"});
}

FrameText head_text(const Matrix& matrix, const Scale& colors) {
  FrameText text{matrix.title, matrix.subtitle, {}};
  if (!matrix.marks.empty()) text.legend.push_back({matrix.mark_label, dot(14.0, 6.0)});
  const bool holes = std::any_of(matrix.values.begin(), matrix.values.end(), [&](double value) {
    return std::isnan(fraction_of(value, colors));
  });
  if (holes) text.legend.push_back({"no value", cross(28.0, 12.0)});
  return text;
}

}  // namespace

std::string svg_of(const Matrix& matrix) {
  check(matrix);
  const Scale colors = color_scale(matrix);
  double below = 0.0;
  std::string content = head_of(head_text(matrix, colors), below);
  const Grid grid = grid_of(matrix, below + 12.0 + kSmall);
  content += cells(matrix, grid, colors) + names(matrix, grid);
  std::vector<std::string> columns;
  for (const Matrix::Column& column : matrix.columns) columns.push_back(column.name);
  double y = grid.top + kRow * static_cast<double>(matrix.rows.size());
  y += 5.0 + widest(columns) + 10.0;
  const double title = svg_text_width(title_of(matrix.value), kSmall);
  const double bar = std::max(grid.left, kEdge + 8.0 + std::min(title, 0.5 * kPlotWidth));
  content += color_bar(matrix, colors, bar, y);
  return svg_file(y + kBarHeight + 5.0 + 1.3 * kSmall + kEdge, matrix.title, content);
}

std::string csv_of(const Matrix& matrix) {
  check(matrix);
  const bool has_marks = !matrix.marks.empty();
  const auto line = [&](std::vector<std::string> fields, const std::string& mark) {
    if (has_marks) fields.push_back(mark);
    return csv_line(fields);
  };
  std::string text =
      line({matrix.rows_label, "group", "column", title_of(matrix.value)}, matrix.mark_label);
  for (std::size_t i = 0; i < matrix.values.size(); ++i) {
    const Matrix::Column& column = matrix.columns[i % matrix.columns.size()];
    text += line({matrix.rows[i / matrix.columns.size()], column.group, column.name,
                  csv_number(matrix.values[i])},
                 has_marks ? csv_number(matrix.marks[i]) : "");
  }
  return text;
}

}  // namespace mapbed
