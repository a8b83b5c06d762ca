#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/config/option.h"

namespace mapbed {

// What a surface does to light and radio waves.
struct Material {
  std::string name = {};
  Eigen::Vector3d color = {0.7, 0.7, 0.7};  // red, green, blue in [0, 1], as on a screen
  double reflectivity = 0.5;  // fraction of laser light that comes back diffusely, [0, 1]

  // Glass. A laser beam passes straight through with probability `transmittance`, except near the
  // normal, where the pane mirrors it back into the receiver; see hit_probability().
  double transmittance = 0.0;   // [0, 1]; 0: opaque
  double specular_hit = 1.0;    // probability of a hit along the normal, [0, 1]
  double specular_width = 0.1;  // [rad] standard deviation of that peak, > 0

  // Radio at 915 MHz.
  double permittivity = 3.75;  // relative, >= 1
  bool conductor = false;      // metal: reflects everything
  double crossing_loss = 3.0;  // [dB] of a wave that goes through once, >= 0
  double tag_loss = 1.0;       // [dB] of the gain of a tag's antenna that sticks on it, >= 0
};

// All but the name and the color, which is three numbers.
template <class Visitor>
void visit_fields(Material& m, Visitor&& visit) {
  visit("reflectivity", m.reflectivity, kFraction,
        "fraction of laser light that comes back diffusely");
  visit("transmittance", m.transmittance, kFraction,
        "probability that a laser beam passes straight through; 0: opaque");
  visit("specular_hit", m.specular_hit, kFraction,
        "of glass: probability of a hit along the normal");
  visit("specular_width", m.specular_width, Unit::radian, between(1e-4, 10.0),
        "of glass: standard deviation of that peak");
  visit("permittivity", m.permittivity, between(1.0, 1e6), "relative, at 915 MHz");
  visit("conductor", m.conductor, "reflects all radio waves");
  visit("crossing_loss", m.crossing_loss, between(0.0, 1000.0),
        "of a radio wave going through once [dB]");
  visit("tag_loss", m.tag_loss, between(0.0, 1000.0),
        "of the antenna of an RFID tag that sticks on it [dB]");
}

// That a laser beam is reflected by the surface and not let through, at an angle of incidence from
// the normal [rad]. 1 for opaque materials.
double hit_probability(const Material& material, double incidence);

// plaster, concrete, brick, wood, metal, glass, plastic, fabric, skin, paint, carpet, ...
const std::vector<Material>& standard_materials();

}  // namespace mapbed
