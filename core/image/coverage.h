#pragma once

#include <span>

#include <Eigen/Core>

#include "core/image/image.h"

namespace mapbed {

// How much of each pixel is covered by shapes, which are added, whatever they overlap, and then
// blended into a picture at once. Quicker than drawing.h, as thousands of frames need it; edges are
// by the distance of a pixel's centre from the shape. Coordinates as there; what lies outside, and
// points that are not finite, are left out.
class Coverage {
 public:
  Coverage(int width, int height);  // [pixels] of the pictures

  // Round joints and ends, also of a single point.
  void add_stroke(std::span<const Eigen::Vector2d> points, double width);
  void add_disc(const Eigen::Vector2d& center, double radius);
  // What lies within an odd number of its borders; the last corner joins the first.
  void add_polygon(std::span<const Eigen::Vector2d> corners);

  // Of the picture's size. Nothing is covered any more then.
  void blend_into(RgbImage& image, const Rgb& color, double opacity = 1.0);

 private:
  struct Box {
    int left, top, right, bottom;  // right and bottom are outside
  };
  Box pixels_about(const Eigen::Vector2d& low, const Eigen::Vector2d& high) const;
  void raise(int x, int y, double coverage);  // to this one where it is less
  void add_segment(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width);
  void touch(const Box& box);

  GrayImage mask_;
  Box touched_;
};

}  // namespace mapbed
