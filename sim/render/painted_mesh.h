#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "worlds/world.h"

namespace mapbed {

// Triangles with colours, as the painter draws them.
struct PaintedVertex {
  std::array<float, 3> position;  // [m] world frame
  std::array<float, 3> normal;    // unit; zero: shines by itself, no light or shadow falls on it
  std::array<float, 4> color;     // red, green, blue as on a screen, opacity
};

struct PaintedMesh {
  std::vector<PaintedVertex> opaque;  // three a triangle
  std::vector<PaintedVertex> clear;   // drawn over it, what is behind shines through
};

struct PaintOptions {
  double cut_height = 0.0;  // [m] walls, columns and doors end here with a dark edge; 0: uncut
};

void paint(PaintedMesh& mesh, const Entity& entity, const std::vector<Material>& materials,
           const PaintOptions& options = {});

// A tag: a bright plate of 16 cm where it sticks, that shines by itself.
void paint(PaintedMesh& mesh, const RfidTag& tag);

// A sweep of a laser: the area it runs through and a spark at every hit.
struct LaserFan {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  std::vector<Eigen::Vector3d> ends = {};  // of the beams, in order
  std::vector<bool> is_hit = {};           // one for each end
  Eigen::Vector3d color = {0.9, 0.1, 0.1};
};
void paint(PaintedMesh& mesh, const LaserFan& fan);

// A band along a path, just above the floor.
void paint_line(PaintedMesh& mesh, const std::vector<Eigen::Vector3d>& points, double width,
                const Eigen::Vector3d& color);

}  // namespace mapbed
