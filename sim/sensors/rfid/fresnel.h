#pragma once

#include "worlds/geometry/material.h"

namespace mapbed {

// What of a wave's field a thick, smooth surface sends back. With c the cosine of the angle of
// incidence, s^2 = 1 - c^2 and e the permittivity:
//   te = (c - sqrt(e - s^2)) / (c + sqrt(e - s^2))         field along the surface
//   tm = (e c - sqrt(e - s^2)) / (e c + sqrt(e - s^2))     field in the plane of incidence
// The sign of tm is that for axes (side, direction x side) before and after; a conductor has -1, 1.
// Losses within the material are left out.
struct Reflection {
  double te = -1.0;
  double tm = 1.0;
};
Reflection reflection_of(const Material& material, double cos_incidence);

}  // namespace mapbed
