#pragma once

#include <Eigen/Core>

#include "algorithms/grid/grid_frame.h"
#include "bench/film/course.h"

namespace mapbed {

// Which part of the world a film shows, and how large.
struct FilmView {
  GridFrame frame;  // of the map's cells, in the world
  int cells_x = 1;  // of the map
  int cells_y = 1;
  int pixels_per_cell = 1;

  int width() const { return cells_x * pixels_per_cell; }   // [pixels] even
  int height() const { return cells_y * pixels_per_cell; }  // [pixels] even
  double pixels_per_meter() const { return pixels_per_cell / frame.resolution; }
  Eigen::Vector2d pixel_of(const Eigen::Vector2d& in_world) const {
    const Eigen::Vector2d cells = frame.in_cells(in_world) * pixels_per_cell;
    return {cells.x(), height() - cells.y()};
  }
};

// What the run's path and the laser reach, but for the far ends of the few beams that went out of a
// window; its longer side has `longest_side` pixels, or few less.
FilmView view_of(const Course& course, int longest_side);

}  // namespace mapbed
