#pragma once

#include "core/config/option.h"

namespace mapbed {

// What a driver needs to know that follows a named path among people.
struct PathFollowingOptions {
  double speed = 0.4;           // [m/s] where the path does not say
  double look_ahead = 0.6;      // [m] the point of the path that is steered for
  double margin = 0.12;         // [m] kept from walls
  double people_margin = 0.25;  // [m] kept from people
  double patience = 3.0;        // [s] waits for somebody in the way, then goes round
};

template <class Visitor>
void visit_fields(PathFollowingOptions& o, Visitor&& visit) {
  visit("speed", o.speed, Unit::meter_per_second, between(0.001, 100.0),
        "where the path does not say");
  visit("look_ahead", o.look_ahead, Unit::meter, between(0.01, 100.0),
        "how far ahead it steers for");
  visit("margin", o.margin, Unit::meter, between(0.0, 10.0), "distance kept from walls");
  visit("people_margin", o.people_margin, Unit::meter, between(0.0, 10.0),
        "distance kept from people");
  visit("patience", o.patience, Unit::second, kNotNegative,
        "waits this long for somebody in the way, then goes round");
}

}  // namespace mapbed
