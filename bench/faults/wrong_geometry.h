#pragma once

#include "bench/faults/broken_log.h"
#include "core/config/option.h"
#include "core/random.h"

namespace mapbed {

struct WrongGeometryOptions {
  double step = 0.0;           // fraction
  double first_bearing = 0.0;  // [rad]
};

template <class Visitor>
void visit_fields(WrongGeometryOptions& o, Visitor&& visit) {
  visit("step", o.step, between(-0.9, 10.0),
        "fraction by which the stated angle from beam to beam is too large; negative: too small");
  visit("first_bearing", o.first_bearing, Unit::radian, between(-6.3, 6.3),
        "by which the stated bearing of the first beam is too large");
}

// Beams do not point where the log says that they do. Each option is a quantity of its own: with
// another step the first beam stays where it was.
BrokenLog with_wrong_geometry(SensorLog log, const WrongGeometryOptions& options, Rng rng);

}  // namespace mapbed
