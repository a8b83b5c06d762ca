#pragma once

#include <vector>

#include "core/config/option.h"
#include "core/image/image.h"
#include "sim/render/painted_mesh.h"
#include "sim/render/painter.h"
#include "worlds/world.h"

namespace mapbed {

enum class View : int { overview, plan };

struct RenderOptions {
  View view = View::overview;
  int width = 1280;                 // [pixels]
  int height = 960;                 // [pixels]
  int samples = 3;                  // along each side of a pixel
  double azimuth = -1.35;           // [rad] where the eye stands, from +x; overview only
  double elevation = 0.95;          // [rad] over the horizon; overview only
  double cut_height = 1.3;          // [m] walls end here, so that one sees into the rooms; 0: uncut
  std::vector<double> center = {};  // [m] x, y of the picture's middle; empty: all of the world's
  double reach = 0.0;               // [m] what is shown around the center; 0: all of the world
  bool shadows = true;
  bool paths = false;  // draw the world's named paths on the floor
};

template <class Visitor>
void visit_fields(RenderOptions& o, Visitor&& visit) {
  visit("view", o.view, {"overview", "plan"}, "from a bird's eye, or straight from above");
  visit("width", o.width, between(16, 8192), "of the picture in pixels");
  visit("height", o.height, between(16, 8192), "of the picture in pixels");
  visit("samples", o.samples, between(1, 4), "along each side of a pixel; more: smoother edges");
  visit("azimuth", o.azimuth, Unit::radian, "where the eye stands, counter-clockwise from +x");
  visit("elevation", o.elevation, Unit::radian, between(0.05, 1.57), "of the eye over the horizon");
  visit("cut_height", o.cut_height, Unit::meter, kNotNegative,
        "walls end here, so that one sees into the rooms; 0: uncut");
  visit("center", o.center, Unit::meter, "x and y of the picture's middle; empty: the world's");
  visit("reach", o.reach, Unit::meter, kNotNegative,
        "how far around the center is shown; 0: all of the world");
  visit("shadows", o.shadows, "the sun throws shadows");
  visit("paths", o.paths, "draw the world's named paths on the floor");
}

// What is in the world for the moment: robots and people where they are, what a laser sees. Their
// materials are the world's.
struct Visitors {
  std::vector<Entity> entities;
  std::vector<LaserFan> fans;
};

RgbImage render_world(const World& world, const RenderOptions& options = {},
                      const Visitors& visitors = {});
// The same with a painter of one's own, for many pictures.
RgbImage render_world(Painter& painter, const World& world, const RenderOptions& options,
                      const Visitors& visitors);

}  // namespace mapbed
