#include "worlds/geometry/material.h"

#include <cmath>

namespace mapbed {

// p(phi) = (1 - T) + (S - (1 - T)) exp(-phi^2 / (2 w^2))
double hit_probability(const Material& m, double incidence) {
  if (m.transmittance <= 0.0) return 1.0;
  const double diffuse = 1.0 - m.transmittance;
  const double off_normal = incidence / m.specular_width;
  return diffuse + (m.specular_hit - diffuse) * std::exp(-0.5 * off_normal * off_normal);
}

// Permittivities: ITU-R P.2040 (concrete, brick, plasterboard, wood, glass), others assumed.
// Losses of tags: assumed; Griffin et al. (RF tag antenna performance on various materials using
// radio link budgets, 2006) have little for cardboard and wood, the most for metal and water.
// Reflectivities at 905 nm and all of glass but its permittivity: assumed, in the usual order from
// bright plaster to dark plastic.
const std::vector<Material>& standard_materials() {
  static const std::vector<Material> materials = {
      {.name = "plaster",
       .color = {0.86, 0.84, 0.79},
       .reflectivity = 0.75,
       .permittivity = 2.94,
       .crossing_loss = 3.0,
       .tag_loss = 1.0},
      {.name = "concrete",
       .color = {0.62, 0.62, 0.60},
       .reflectivity = 0.45,
       .permittivity = 5.31,
       .crossing_loss = 12.0,
       .tag_loss = 3.0},
      {.name = "brick",
       .color = {0.62, 0.36, 0.28},
       .reflectivity = 0.5,
       .permittivity = 3.75,
       .crossing_loss = 7.0,
       .tag_loss = 2.0},
      {.name = "wood",
       .color = {0.60, 0.43, 0.26},
       .reflectivity = 0.55,
       .permittivity = 1.99,
       .crossing_loss = 2.5,
       .tag_loss = 1.0},
      {.name = "metal",
       .color = {0.52, 0.55, 0.58},
       .reflectivity = 0.5,
       .permittivity = 1.0,
       .conductor = true,
       .crossing_loss = 30.0,
       .tag_loss = 15.0},
      {.name = "glass",
       .color = {0.60, 0.80, 0.85},
       .reflectivity = 0.1,
       .transmittance = 0.7,
       .specular_hit = 0.95,
       .specular_width = 0.1,
       .permittivity = 6.27,
       .crossing_loss = 1.5,
       .tag_loss = 3.0},
      {.name = "plastic",
       .color = {0.25, 0.27, 0.30},
       .reflectivity = 0.3,
       .permittivity = 2.5,
       .crossing_loss = 0.5,
       .tag_loss = 0.5},
      {.name = "fabric",
       .color = {0.24, 0.34, 0.52},
       .reflectivity = 0.4,
       .permittivity = 1.5,
       .crossing_loss = 0.3,
       .tag_loss = 0.0},
      {.name = "clothes",
       .color = {0.55, 0.20, 0.20},
       .reflectivity = 0.4,
       .permittivity = 40.0,
       .crossing_loss = 10.0,
       .tag_loss = 6.0},
      {.name = "stone",
       .color = {0.78, 0.74, 0.66},
       .reflectivity = 0.6,
       .permittivity = 6.0,
       .crossing_loss = 15.0,
       .tag_loss = 3.0},
      {.name = "carpet",
       .color = {0.52, 0.54, 0.58},
       .reflectivity = 0.3,
       .permittivity = 2.0,
       .crossing_loss = 10.0,
       .tag_loss = 0.5},
      {.name = "parquet",
       .color = {0.72, 0.58, 0.42},
       .reflectivity = 0.5,
       .permittivity = 2.5,
       .crossing_loss = 10.0,
       .tag_loss = 1.0},
      {.name = "leaf",
       .color = {0.27, 0.47, 0.22},
       .reflectivity = 0.5,
       .permittivity = 30.0,
       .crossing_loss = 5.0,
       .tag_loss = 4.0},
  };
  return materials;
}

}  // namespace mapbed
