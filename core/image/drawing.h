#pragma once

#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "core/image/image.h"

namespace mapbed {

// Drawing on a picture, with smooth edges, by OpenCV. Coordinates are in pixels from the top left
// corner of the picture, x right and y down: the pixel (3, 2) covers [3, 4) x [2, 3) and has its
// centre at (3.5, 2.5). What lies outside is cut off.

struct Pen {
  Rgb color = kBlack;
  double width = 1.0;    // [pixels], drawn to within 0.2
  double opacity = 1.0;  // 0 nothing to be seen, 1 covers what was there
};

void draw_line(RgbImage& image, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
               const Pen& pen);

// A path with round joints and ends, also of a single point. Where it crosses itself it is not
// darker. A point that is not finite interrupts it.
void draw_polyline(RgbImage& image, const std::vector<Eigen::Vector2d>& points, const Pen& pen);

void fill_disc(RgbImage& image, const Eigen::Vector2d& center, double radius, const Rgb& color,
               double opacity = 1.0);

// From corner to opposite corner, edges on fractions of a pixel included.
void fill_rectangle(RgbImage& image, const Eigen::Vector2d& corner, const Eigen::Vector2d& opposite,
                    const Rgb& color, double opacity = 1.0);

// Text in one font of simple strokes: ASCII and ° ± × ² µ. Any other sign is drawn as a box. Best
// from 10 to 30 pixels.
struct TextStyle {
  double size = 13.0;  // [pixels] from line to line it takes 1.25 of this; capitals are 0.7 high
  Rgb color = kBlack;
  double halo = 0.0;  // [pixels] width of a white edge that sets the text off from a map
};

// `start` is the left end of the base line; it is moved to the nearest pixel, which keeps
// horizontal strokes sharp.
void draw_text(RgbImage& image, const Eigen::Vector2d& start, std::string_view text,
               const TextStyle& style = {});

double text_width(std::string_view text, double size);  // [pixels]

// Pastes `small` into the picture, each of its pixels `scale` wide and high, its corner at (x, y).
// All of it has to fit.
void paste(const RgbImage& small, int scale, RgbImage& image, int x, int y);

}  // namespace mapbed
