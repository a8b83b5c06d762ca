#pragma once

namespace mapbed {

// What a number is measured in. Files write the unit ("2 cm", "5 deg"), the code holds SI and
// radians.
enum class Unit {
  none,
  meter,
  radian,
  second,
  hertz,
  kilogram,
  meter_per_second,
  radian_per_second,
  radian_per_meter,
  meter_per_second_squared,
  radian_per_second_squared,
  newton,
};

}  // namespace mapbed
