#include "sim/sensors/rfid/fresnel.h"

#include <cmath>

namespace mapbed {

Reflection reflection_of(const Material& material, double cos_incidence) {
  if (material.conductor) return {-1.0, 1.0};
  const double c = cos_incidence;
  const double e = material.permittivity;
  const double root = std::sqrt(e - 1.0 + c * c);
  if (root == 0.0) return {0.0, 0.0};  // of no other density than air, met along the surface
  return {(c - root) / (c + root), (e * c - root) / (e * c + root)};
}

}  // namespace mapbed
