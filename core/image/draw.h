#pragma once

#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "core/image/image.h"

namespace mapbed {

// Drawing on a picture, with smooth edges. Coordinates are in pixels from the top left corner of
// the picture, x right and y down: the pixel (3, 2) covers [3, 4) x [2, 3) and has its centre at
// (3.5, 2.5). What lies outside is cut off.

struct Pen {
  Rgb color = kBlack;
  double width = 1.0;    // [pixels]
  double opacity = 1.0;  // 0 nothing to be seen, 1 covers what was there
};

// Mixes a colour into one pixel; outside the picture nothing happens.
void blend(RgbImage& image, int x, int y, const Rgb& color, double opacity);

void draw_line(RgbImage& image, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
               const Pen& pen);

// A path with round joints and ends, also of a single point. Where it crosses itself it is not
// darker. A point that is not finite interrupts it.
void draw_polyline(RgbImage& image, const std::vector<Eigen::Vector2d>& points, const Pen& pen);

// Several paths that count as one: no darker where they cross.
void draw_polylines(RgbImage& image, const std::vector<std::vector<Eigen::Vector2d>>& paths,
                    const Pen& pen);

void fill_disc(RgbImage& image, const Eigen::Vector2d& center, double radius, const Rgb& color,
               double opacity = 1.0);
void draw_circle(RgbImage& image, const Eigen::Vector2d& center, double radius, const Pen& pen);

// From corner to opposite corner, edges on fractions of a pixel included.
void fill_rectangle(RgbImage& image, const Eigen::Vector2d& corner, const Eigen::Vector2d& opposite,
                    const Rgb& color, double opacity = 1.0);

}  // namespace mapbed
