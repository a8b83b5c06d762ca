#pragma once

#include <string>
#include <string_view>

#include "core/config/option.h"
#include "core/input_error.h"

namespace mapbed {

// A number with its unit, as files write it: "2 cm", "-5 deg", "0.1 m/s", "250 ms", "10 Hz". In SI
// and radians. A bare number is right where the unit is none; elsewhere only 0 goes without one.
// Throws InputError on a wrong or missing unit, NaN, infinity and anything that is not a number.
double parse_quantity(std::string_view text, Unit unit, const SourceLocation& place);

// The shortest text that parse_quantity turns into the same value again. `value` is finite.
std::string quantity_text(double value, Unit unit);

// "length [m]", "angle [rad]"; "number" for none.
std::string unit_name(Unit unit);

}  // namespace mapbed
