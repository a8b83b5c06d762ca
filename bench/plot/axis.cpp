#include "bench/plot/axis.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/check.h"

namespace mapbed {
namespace {

constexpr double kSameNumber = 1e-9;  // numbers that differ by less, relatively, are drawn as one
constexpr double kMostDecades = 250;  // of a logarithmic axis
constexpr double kNoPlace = std::numeric_limits<double>::quiet_NaN();

// The smallest of 1, 2, 5 times a power of ten that is at least `step`.
double round_step(double step) {
  const double power = std::pow(10.0, std::floor(std::log10(step)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= step * (1.0 - 1e-9)) return factor * power;
  }
  return 10.0 * power;
}

std::vector<Tick> linear_ticks(const Scale& scale, int count) {
  const double step = round_step((scale.high - scale.low) / count);
  const double slack = 1e-9 * (scale.high - scale.low);
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  const double largest = std::max(std::abs(scale.low), std::abs(scale.high));
  std::vector<Tick> ticks;
  const double first = std::ceil((scale.low - slack) / step);
  for (int k = 0; k <= 3 * count; ++k) {  // of large numbers, adding 1 may do nothing
    const double i = first + k;
    if (!(i * step <= scale.high + slack)) break;
    const double value = i == 0.0 ? 0.0 : i * step;
    const bool plain = largest < 1e6 && decimals <= 4;
    std::string text = plain ? fmt::format("{:.{}f}", value, decimals) : number_text(value, 4);
    if (text.front() == '-') text.replace(0, 1, "\u2212");
    ticks.push_back({value, std::move(text)});
  }
  return ticks;
}

std::vector<Tick> logarithmic_ticks(const Scale& scale, int count) {
  const double decades = std::log10(scale.high / scale.low);
  const int every = std::max(1, static_cast<int>(std::ceil(decades / count)));  // decades
  const int first = static_cast<int>(std::floor(std::log10(scale.low)));
  std::vector<Tick> ticks;
  for (int decade = first; decade < 308 && std::pow(10.0, decade) <= scale.high * (1 + 1e-9);
       ++decade) {
    for (int factor = 1; factor <= 9; ++factor) {
      const double value = factor * std::pow(10.0, decade);
      if (value < scale.low * (1 - 1e-9) || value > scale.high * (1 + 1e-9)) continue;
      const bool of_decade = factor == 1 && decade % every == 0;
      const bool between = decades < 2.0 && (factor == 2 || factor == 5);
      if (every > 1 && factor > 1) continue;
      ticks.push_back({value, of_decade || between ? number_text(value) : ""});
    }
  }
  return ticks;
}

}  // namespace

std::string title_of(const Axis& axis) {
  return axis.unit.empty() ? axis.label : axis.label + " [" + axis.unit + "]";
}

double Scale::fraction(double value) const {
  if (!std::isfinite(value)) return kNoPlace;
  if (!logarithmic) return (value - low) / (high - low);
  return value > 0.0 ? std::log(value / low) / std::log(high / low) : kNoPlace;
}

double Scale::value(double fraction) const {
  return logarithmic ? low * std::pow(high / low, fraction) : std::lerp(low, high, fraction);
}

Scale scale_of(const Axis& axis, std::span<const double> values, bool from_zero) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const double value : values) {
    if (!std::isfinite(value) || (axis.logarithmic && value <= 0.0)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (low > high) {  // nothing to show
    low = axis.logarithmic ? 0.1 : 0.0;
    high = 1.0;
  }
  if (axis.logarithmic) {
    low = std::max(low, high * std::pow(10.0, -kMostDecades));
    const double room = std::max(std::pow(high / low, 0.04), 1.1);
    low /= room;
    high = std::min(high * room, 1e307);
  } else if (!axis.categories.empty()) {
    low = -0.5;
    high = static_cast<double>(axis.categories.size()) - 0.5;
  } else {
    const bool near_zero = low >= 0.0 && low <= 0.35 * high;
    const double size = std::max(std::abs(low), std::abs(high));
    const double room =
        high - low > kSameNumber * size ? 0.05 * (high - low) : std::max(0.1 * std::abs(high), 0.5);
    const bool at_zero = near_zero || (from_zero && low >= 0.0);
    high = from_zero && high <= 0.0 ? 0.0 : high + room;
    low = at_zero ? 0.0 : low < 0.0 ? low - room : std::max(0.0, low - room);
  }
  Scale scale{axis.low.value_or(low), axis.high.value_or(high), axis.logarithmic};
  // Only one end was given, and the data lie all beyond it.
  if (scale.high <= scale.low) {
    (axis.low ? scale.high : scale.low) = axis.logarithmic
                                              ? (axis.low ? 10.0 * scale.low : 0.1 * scale.high)
                                              : (axis.low ? scale.low + 1.0 : scale.high - 1.0);
  }
  CHECK(scale.high > scale.low && (!scale.logarithmic || scale.low > 0.0));
  return scale;
}

std::vector<Tick> ticks_of(const Scale& scale, int count) {
  CHECK(count > 0);
  return scale.logarithmic ? logarithmic_ticks(scale, count) : linear_ticks(scale, count);
}

std::vector<Tick> ticks_of(const Axis& axis, const Scale& scale, int count) {
  if (axis.categories.empty()) return ticks_of(scale, count);
  std::vector<Tick> ticks;
  for (std::size_t i = 0; i < axis.categories.size(); ++i) {
    ticks.push_back({static_cast<double>(i), axis.categories[i]});
  }
  return ticks;
}

std::string number_text(double value, int digits) {
  if (std::isnan(value)) return "\u2013";
  std::string text = fmt::format("{:.{}g}", value, digits);
  const double size = std::abs(value);
  if (size >= 1.0 && size < 1e6) {  // no exponent: 12000 and not 1.2e+04
    const int before = static_cast<int>(std::floor(std::log10(size))) + 1;
    text = fmt::format("{:.{}f}", value, std::max(0, digits - before));
    if (text.find('.') != std::string::npos) {
      text.erase(text.find_last_not_of('0') + 1);
      if (text.back() == '.') text.pop_back();
    }
  }
  for (std::size_t at = text.find('-'); at != std::string::npos; at = text.find('-', at + 1)) {
    text.replace(at, 1, "\u2212");
  }
  return text;
}

}  // namespace mapbed
