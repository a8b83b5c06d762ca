#include "bench/plot/antenna_picture.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "bench/plot/map_legend.h"
#include "core/config/quantity.h"
#include "core/geometry/angle.h"
#include "core/image/color_map.h"
#include "core/image/drawing.h"
#include "core/input_error.h"
#include "sim/sensors/rfid/rfid_field.h"
#include "worlds/geometry/footprint.h"
#include "worlds/worlds.h"

namespace mapbed {
namespace {

using Eigen::Vector2d;

constexpr int kMostCells = 250;     // along the longer side: each is a hundred ways of a wave
constexpr double kLow = -40.0;      // [dBm] ends of the scale
constexpr double kHigh = 10.0;      // [dBm]
constexpr double kBarRoom = 90.0;   // [pixels] of the scale with its numbers
constexpr double kBarWidth = 16.0;  // [pixels]
constexpr int kMargin = 12;         // [pixels]
constexpr Rgb kContour{255, 80, 60};
constexpr Rgb kWall{255, 255, 255};

Pose3 placed(const std::string& text) {
  const SourceLocation place{"--antenna", 0};
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ',') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  if (parts.size() != 4) {
    throw InputError(place, "an antenna has a place and a heading",
                     "write x, y, z, heading, as in '7 m, 6.6 m, 0.6 m, 45 deg'");
  }
  std::vector<double> values;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    values.push_back(parse_quantity(parts[i], i < 3 ? Unit::meter : Unit::radian, place));
  }
  return {{values[0], values[1], values[2]}, rotation_of(values[3], 0.0, 0.0)};
}

RfidModel model_of(const std::string& sensor) {
  const SensorModel model = load_sensor(sensor);
  const auto* rfid = std::get_if<RfidModel>(&model);
  if (rfid == nullptr) {
    throw InputError("sensor " + in_quotes(sensor) + " is no RFID antenna; name one of kind rfid");
  }
  return *rfid;
}

// What is shown, in cells.
struct Frame {
  Vector2d low;
  double cell = 0.1;  // [m]
  int columns = 0, rows = 0;
  int scale = 1;  // [pixels] of a cell's side

  Vector2d center_of(int column, int row) const {  // rows from the top
    return low + cell * Vector2d(column + 0.5, rows - row - 0.5);
  }
  Vector2d pixel_of(const Vector2d& point) const {
    const Vector2d cells = (point - low) / cell;
    return Vector2d::Constant(kMargin) + scale * Vector2d(cells.x(), rows - cells.y());
  }
};

Frame frame_of(const World& world, const AntennaPicture& picture, const Vector2d& antenna) {
  Eigen::AlignedBox3d bounds = bounds_of(world);
  if (bounds.isEmpty()) bounds.extend(Eigen::Vector3d(antenna.x(), antenna.y(), 0.0));
  Vector2d low = bounds.min().head<2>();
  Vector2d high = bounds.max().head<2>();
  if (picture.reach > 0.0) {
    const Vector2d middle =
        picture.center.size() == 2 ? Vector2d(picture.center[0], picture.center[1]) : antenna;
    low = middle.array() - picture.reach;
    high = middle.array() + picture.reach;
  }
  const Vector2d size = high - low;
  Frame frame{.low = low};
  frame.scale = std::max(1, picture.longest_side / kMostCells);
  const int most = std::max(10, picture.longest_side / frame.scale);
  frame.cell = size.maxCoeff() / most;
  frame.columns = std::max(1, static_cast<int>(std::lround(size.x() / frame.cell)));
  frame.rows = std::max(1, static_cast<int>(std::lround(size.y() / frame.cell)));
  return frame;
}

// [dBm] row by row from the top; the end of the scale where too little arrives.
std::vector<double> powers(const World& world, const RfidModel& model, const Pose3& antenna,
                           const Frame& frame, double tag_height) {
  const Scene scene(world);
  const RfidField field(world, {{.model = model}});
  std::vector<double> result;
  for (int row = 0; row < frame.rows; ++row) {
    for (int column = 0; column < frame.columns; ++column) {
      const Vector2d at = frame.center_of(column, row);
      const Vector2d back = antenna.position.head<2>() - at;
      const RfidTag tag{
          "",
          {{at.x(), at.y(), tag_height}, rotation_of(std::atan2(back.y(), back.x()), 0.0, 0.0)},
          RfidTag::kNothing};
      const std::optional<IdealTag> received = field.at(scene, 0, antenna, tag);
      result.push_back(received ? received->power : kLow);
    }
  }
  return result;
}

void draw_walls(RgbImage& image, const World& world, const Frame& frame, double height) {
  for (const Footprint& part : footprints(world, height - 1e-3, height + 1e-3)) {
    std::vector<Vector2d> outline;
    for (const Vector2d& corner : part.outline) outline.push_back(frame.pixel_of(corner));
    constexpr int kSides = 24;
    for (int k = 0; part.outline.empty() && k < kSides; ++k) {
      const double angle = 2.0 * kPi * k / kSides;
      outline.push_back(
          frame.pixel_of(part.center + part.radius * Vector2d(std::cos(angle), std::sin(angle))));
    }
    outline.push_back(outline.front());
    draw_polyline(image, outline, {.color = kWall, .width = 1.6});
  }
}

// Along the cells' sides between those on either side of the threshold.
void draw_contour(RgbImage& image, const std::vector<double>& values, const Frame& frame,
                  double threshold) {
  const auto is_over = [&](int column, int row) {
    return values[static_cast<std::size_t>(row * frame.columns + column)] > threshold;
  };
  const auto corner = [&](int column, int row) {
    return Vector2d(kMargin + frame.scale * column, kMargin + frame.scale * row);
  };
  const Pen pen{.color = kContour, .width = 2.0};
  for (int row = 0; row < frame.rows; ++row) {
    for (int column = 0; column < frame.columns; ++column) {
      const bool here = is_over(column, row);
      if (column + 1 < frame.columns && here != is_over(column + 1, row)) {
        draw_line(image, corner(column + 1, row), corner(column + 1, row + 1), pen);
      }
      if (row + 1 < frame.rows && here != is_over(column, row + 1)) {
        draw_line(image, corner(column, row + 1), corner(column + 1, row + 1), pen);
      }
    }
  }
}

Rgb color_of_power(double power) {
  return color_of(ColorMap::blue_to_yellow, (power - kLow) / (kHigh - kLow));
}

void draw_scale(RgbImage& image, const Vector2d& top, double height, double threshold) {
  const int rows = static_cast<int>(height);
  for (int y = 0; y < rows; ++y) {
    const double power = kHigh - (kHigh - kLow) * (y + 0.5) / rows;
    fill_rectangle(image, top + Vector2d(0.0, y), top + Vector2d(kBarWidth, y + 1.0),
                   color_of_power(power));
  }
  const auto at = [&](double power) { return (kHigh - power) / (kHigh - kLow) * height; };
  for (double power = kLow; power <= kHigh; power += 10.0) {
    const std::string unit = power == kHigh ? " dBm" : "";
    draw_text(image, top + Vector2d(kBarWidth + 6.0, at(power) + (power == kHigh ? 10.0 : 0.0)),
              fmt::format("{:g}{}", power, unit));
  }
  const Vector2d mark = top + Vector2d(0.0, at(threshold));
  draw_line(image, mark, mark + Vector2d(kBarWidth + 4.0, 0.0), {.color = kContour, .width = 3.0});
}

void draw_antenna(RgbImage& image, const Frame& frame, const Pose3& antenna) {
  const Vector2d at = frame.pixel_of(antenna.position.head<2>());
  const double heading = planar(antenna).theta;
  const Vector2d tip = at + 34.0 * Vector2d(std::cos(heading), -std::sin(heading));
  draw_line(image, at, tip, {.color = kWhite, .width = 5.0});
  draw_line(image, at, tip, {.color = kBlack, .width = 3.0});
  fill_disc(image, at, 7.0, kWhite);
  fill_disc(image, at, 5.0, kBlack);
}

}  // namespace

RgbImage picture_of(const AntennaPicture& picture) {
  const World world = build_world(picture.world, picture.world_settings);
  const Pose3 antenna = placed(picture.antenna);
  const RfidModel model = model_of(picture.sensor);
  const Frame frame = frame_of(world, picture, antenna.position.head<2>());
  const std::vector<double> values = powers(world, model, antenna, frame, picture.tag_height);

  RgbImage cells(frame.columns, frame.rows);
  std::transform(values.begin(), values.end(), cells.pixels().begin(), color_of_power);
  const int width = frame.scale * frame.columns;
  const int height = frame.scale * frame.rows;
  RgbImage image(width + 3 * kMargin + static_cast<int>(kBarRoom),
                 height + 3 * kMargin + kLegendRow, kWhite);
  paste(cells, frame.scale, image, kMargin, kMargin);
  draw_contour(image, values, frame, model.threshold);
  draw_walls(image, world, frame, picture.tag_height);
  draw_antenna(image, frame, antenna);
  // What was drawn beyond the map.
  fill_rectangle(image, {kMargin + width, 0.0}, {image.width(), image.height()}, kWhite);
  fill_rectangle(image, {0.0, kMargin + height}, {image.width(), image.height()}, kWhite);
  fill_rectangle(image, {0.0, 0.0}, {kMargin, image.height()}, kWhite);
  fill_rectangle(image, {0.0, 0.0}, {image.width(), kMargin}, kWhite);
  draw_scale(image, {2.0 * kMargin + width, kMargin + 10.0}, height - 10.0, model.threshold);
  const double base = height + 2 * kMargin + kLegendRow / 2.0;
  draw_scale_bar(image, {kMargin, base}, frame.scale / frame.cell, width / 2.0);
  draw_legend(image,
              {{LegendItem::Kind::line, kContour,
                fmt::format("{:g} dBm: every second tag answers", model.threshold)}},
              {kMargin + width / 2.0, base}, width / 2.0);
  return image;
}

}  // namespace mapbed
