#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace mapbed {

// What is written at an axis, and how far it goes.
struct Axis {
  std::string label;               // "error of the position"
  std::string unit;                // "m"; empty: a number without one
  bool logarithmic = false;        // values of 0 and less have no place on it and become gaps
  std::optional<double> low = {};  // where the axis ends; else where the data do
  std::optional<double> high = {};
  std::vector<std::string> categories = {};  // not empty: value i is drawn as categories[i]
};

// "error of the position [m]"
std::string title_of(const Axis& axis);

// Where a value comes to lie on an axis.
struct Scale {
  double low = 0.0;
  double high = 1.0;  // more than low
  bool logarithmic = false;

  double fraction(double value) const;  // 0 at low, 1 at high; NaN where the value has no place
  double value(double fraction) const;  // the inverse
};

// Room for all finite values (positive ones on a logarithmic axis) and a little more, but not below
// 0 where none of them is; from 0 on where they come near it or `from_zero` is set.
Scale scale_of(const Axis& axis, std::span<const double> values, bool from_zero = false);

struct Tick {
  double value = 0.0;
  std::string text;  // empty: a small tick without text
};

// At 1, 2 or 5 times a power of ten, between `low` and `high`; about `count` of them have a text.
// At the powers of ten alone where a logarithmic scale spans many.
std::vector<Tick> ticks_of(const Scale& scale, int count);

// One tick for each category.
std::vector<Tick> ticks_of(const Axis& axis, const Scale& scale, int count);

// A number as people write it: 0.05, 1200, 3e-7, with a proper minus.
std::string number_text(double value, int digits = 3);

}  // namespace mapbed
