#include "core/config/option.h"

#include <algorithm>
#include <cmath>

namespace mapbed {
namespace {

double largest_value(Unit unit) {
  switch (unit) {
    case Unit::none:
      return 1e12;
    case Unit::meter:
      return 1e4;
    case Unit::radian:
      return 1e2;
    case Unit::second:
      return 1e10;  // stamps count from 1970
    case Unit::hertz:
      return 1e10;
    case Unit::kilogram:
    case Unit::newton:
      return 1e6;
    case Unit::meter_per_second:
    case Unit::radian_per_second:
    case Unit::radian_per_meter:
    case Unit::meter_per_second_squared:
    case Unit::radian_per_second_squared:
      return 1e3;
  }
  return 0.0;
}

}  // namespace

Bounds finite_bounds(Unit unit, const Bounds& bounds) {
  const double largest = largest_value(unit);
  Bounds result = bounds;
  if (std::isinf(result.low)) result.low = -largest;
  if (std::isinf(result.high)) result.high = std::max(largest, result.low);
  return result;
}

namespace option_detail {

Collector::Collector(OptionList& list, std::string prefix)
    : list_(list), prefix_(std::move(prefix)) {}

void Collector::add(std::string_view name, OptionValue value, Unit unit, const Bounds& bounds,
                    std::string_view about) {
  const bool is_seed = std::holds_alternative<std::uint64_t*>(value);
  list_.push_back({prefix_ + std::string(name), std::move(value), unit,
                   is_seed ? bounds : finite_bounds(unit, bounds), std::string(about)});
}

}  // namespace option_detail
}  // namespace mapbed
