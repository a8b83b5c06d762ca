#pragma once

#include <string>
#include <string_view>

#include "core/config/unit.h"
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

// The SI symbol, "m/s", as tables and configurations have it; empty for none.
std::string unit_symbol(Unit unit);

// The unit of an SI symbol; Unit::none for an empty one. Throws InputError on any other text.
Unit unit_of_symbol(std::string_view symbol, const SourceLocation& place);

// Numbers as people read them, on axes and pages and in messages: angles in degrees, all else in
// SI.
double displayed(double value, Unit unit);
std::string display_symbol(Unit unit);  // "deg/s"; empty for none

}  // namespace mapbed
