#include "bench/figures/detection_field_figure.h"

#include <cmath>

#include "bench/figures/figure_sheet.h"
#include "bench/figures/plane_panel.h"
#include "core/geometry/angle.h"
#include "core/image/color_map.h"

namespace mapbed {
namespace {

constexpr double kPanelWidth = 520.0;  // [px]
constexpr Rgb kArcColor{213, 94, 0};
constexpr Rgb kHalfColor{0, 158, 115};

std::vector<Eigen::Vector2d> outline_of(const PiecewiseAntenna& antenna) {
  constexpr int kSteps = 60;
  const double first = antenna.direction - 0.5 * antenna.opening;
  std::vector<Eigen::Vector2d> points{Eigen::Vector2d::Zero()};
  for (int i = 0; i <= kSteps; ++i) {
    const double bearing = first + antenna.opening * i / kSteps;
    points.emplace_back(antenna.range * std::cos(bearing), antenna.range * std::sin(bearing));
  }
  points.emplace_back(0.0, 0.0);
  return points;
}

// Where the smooth model's power is the tag's threshold.
std::vector<Eigen::Vector2d> threshold_of(const SmoothAntenna& antenna) {
  std::vector<Eigen::Vector2d> points;
  for (int i = -180; i <= 180; ++i) {
    const double bearing = radians(i);
    const double turned = angle_difference(antenna.direction, bearing) / antenna.beam_width;
    const double loss = std::min(12.0 * turned * turned, antenna.back);
    const double distance = std::pow(10.0, (antenna.level - loss) / antenna.falloff);
    points.emplace_back(distance * std::cos(bearing), distance * std::sin(bearing));
  }
  return points;
}

PlanePanel panel_of(const DetectionField& field) {
  const HistogramAntenna& counted = field.counted;
  const double half = 0.5 * counted.cells * counted.cell_size;
  PlanePanel panel(Eigen::AlignedBox2d(Eigen::Vector2d(-half, -half), Eigen::Vector2d(half, half)),
                   kPanelWidth / (2.0 * half));
  int cell = 0;
  panel.shade(counted.cell_size, [&](const Eigen::Vector2d&) {
    const auto i = static_cast<std::size_t>(cell++);
    if (i >= counted.rounds.size() || counted.rounds[i] == 0.0) return Rgb{225, 225, 225};
    return color_of(ColorMap::blue_to_yellow, counted.detections[i] / counted.rounds[i]);
  });
  panel.draw_path(outline_of(field.piecewise), kArcColor);
  panel.draw_ring({0.0, 0.0}, field.piecewise.disc_radius, kArcColor, false);
  panel.draw_path(threshold_of(field.smooth), kHalfColor);
  panel.draw_border();
  return panel;
}

}  // namespace

RgbImage detection_field_figure(const std::vector<DetectionField>& fields) {
  std::vector<FigurePanel> panels;
  double scale = 1.0;
  for (const DetectionField& field : fields) {
    const PlanePanel panel = panel_of(field);
    scale = panel.pixels_per_meter();
    panels.push_back({panel.image(), field.name});
  }
  using Kind = LegendItem::Kind;
  std::vector<LegendItem> legend{{Kind::line, kArcColor, "arc and disc"},
                                 {Kind::line, kHalfColor, "link budget: every second round"},
                                 {Kind::area, Rgb{225, 225, 225}, "never there"}};
  for (const int percent : {0, 25, 50, 75, 100}) {
    legend.push_back({Kind::area, color_of(ColorMap::blue_to_yellow, 0.01 * percent),
                      std::to_string(percent) + " % of rounds"});
  }
  return sheet_of(panels, static_cast<int>(panels.size()), scale, legend);
}

}  // namespace mapbed
