#include "core/config/quantity.h"

#include <array>
#include <charconv>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "core/check.h"
#include "core/file/tokens.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

// One way of writing a unit. The value in SI is number * times / per: "2 cm" is 2 / 100, which is
// rounded once, where 2 * 0.01 would be rounded twice. An angle in degrees goes through radians().
struct Symbol {
  std::string_view text;
  double times = 1.0;
  double per = 1.0;
  bool in_degrees = false;
};

struct Dimension {
  Unit unit;
  std::string_view noun;        // "'2 kg' is not a length"
  std::string_view remedy;      // "write e.g. …"
  std::vector<Symbol> symbols;  // the SI one first
};

const std::vector<Dimension>& dimensions() {
  static const std::vector<Dimension> all = {
      {Unit::meter,
       "length",
       "'2 m' or '2 cm'",
       {{"m"}, {"cm", 1, 100}, {"mm", 1, 1000}, {"km", 1000}}},
      {Unit::radian,
       "angle",
       "'5 deg' or '0.1 rad'",
       {{"rad"}, {"deg", 1, 1, true}, {"mrad", 1, 1000}}},
      {Unit::second,
       "time",
       "'2 s' or '250 ms'",
       {{"s"}, {"ms", 1, 1000}, {"us", 1, 1e6}, {"ns", 1, 1e9}, {"min", 60}, {"h", 3600}}},
      {Unit::hertz, "rate", "'10 Hz'", {{"Hz"}, {"kHz", 1e3}, {"MHz", 1e6}, {"GHz", 1e9}}},
      {Unit::kilogram, "mass", "'2 kg' or '500 g'", {{"kg"}, {"g", 1, 1000}}},
      {Unit::meter_per_second,
       "speed",
       "'0.5 m/s' or '2 cm/s'",
       {{"m/s"}, {"cm/s", 1, 100}, {"mm/s", 1, 1000}, {"km/h", 1, 3.6}}},
      {Unit::radian_per_second,
       "turn rate",
       "'30 deg/s' or '0.5 rad/s'",
       {{"rad/s"}, {"deg/s", 1, 1, true}, {"deg/h", 1, 3600, true}}},
      {Unit::radian_per_meter,
       "angle per length",
       "'3 deg/m' or '0.05 rad/m'",
       {{"rad/m"}, {"deg/m", 1, 1, true}}},
      {Unit::meter_per_second_squared,
       "acceleration",
       "'0.5 m/s^2'",
       {{"m/s^2"}, {"m/s2"}, {"cm/s^2", 1, 100}}},
      {Unit::radian_per_second_squared,
       "angular acceleration",
       "'90 deg/s^2' or '2 rad/s^2'",
       {{"rad/s^2"}, {"deg/s^2", 1, 1, true}}},
      {Unit::newton, "force", "'20 N'", {{"N"}, {"kN", 1000}}},
  };
  return all;
}

const Dimension& dimension_of(Unit unit) {
  for (const Dimension& dimension : dimensions()) {
    if (dimension.unit == unit) return dimension;
  }
  CHECK(!"a unit without symbols");
  return dimensions().front();
}

// "deg/s" of a turn rate; null where there is no angle in it.
const Symbol* display_symbol_of(Unit unit) {
  if (unit == Unit::none) return nullptr;
  for (const Symbol& symbol : dimension_of(unit).symbols) {
    if (symbol.in_degrees && symbol.per == 1.0) return &symbol;
  }
  return nullptr;
}

bool is_known_symbol(std::string_view text) {
  for (const Dimension& dimension : dimensions()) {
    for (const Symbol& symbol : dimension.symbols) {
      if (symbol.text == text) return true;
    }
  }
  return false;
}

double in_si(double number, const Symbol& symbol) {
  const double value = symbol.in_degrees ? radians(number) : number;
  return value * symbol.times / symbol.per;
}

std::string shortest(double value) {
  std::array<char, 32> digits;
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  CHECK(error == std::errc());
  return {digits.data(), end};
}

std::string with_article(std::string_view noun) {
  const bool vowel = noun.find_first_of("aeiou") == 0;
  return (vowel ? "an " : "a ") + std::string(noun);
}

}  // namespace

double parse_quantity(std::string_view text, Unit unit, const SourceLocation& place) {
  const std::string_view stripped = without_blanks(text);
  const std::string shown = in_quotes(stripped);
  // from_chars takes no leading '+' and does take "nan" and "inf"
  const bool plus = stripped.size() > 1 && stripped[0] == '+' && stripped[1] != '-';
  const std::string_view digits = stripped.substr(plus ? 1 : 0);
  double number = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error == std::errc::result_out_of_range) {
    throw InputError(place, shown + " is too large or too small for a number");
  }
  if (error != std::errc()) {
    throw InputError(
        place, shown + " is not a number",
        unit == Unit::none ? "" : "write e.g. " + std::string(dimension_of(unit).remedy));
  }
  if (!std::isfinite(number)) throw InputError(place, shown + " is not a finite number");

  const std::string_view symbol_text =
      without_blanks({end, static_cast<std::size_t>(digits.data() + digits.size() - end)});
  if (unit == Unit::none) {
    if (symbol_text.empty()) return number;
    if (is_known_symbol(symbol_text)) {
      throw InputError(place, shown + " has a unit, but a bare number is asked for",
                       "write '" + shortest(number) + "'");
    }
    throw InputError(place, shown + " is not a number");
  }
  const Dimension& dimension = dimension_of(unit);
  const std::string remedy = "write e.g. " + std::string(dimension.remedy);
  if (symbol_text.empty()) {
    if (number == 0.0) return number;
    throw InputError(place, shown + " needs a unit: it is " + with_article(dimension.noun), remedy);
  }
  for (const Symbol& symbol : dimension.symbols) {
    if (symbol.text != symbol_text) continue;
    const double value = in_si(number, symbol);
    if (!std::isfinite(value)) throw InputError(place, shown + " is too large for a number");
    return value;
  }
  throw InputError(place, shown + " is not " + with_article(dimension.noun), remedy);
}

std::string quantity_text(double value, Unit unit) {
  CHECK(std::isfinite(value));
  if (unit == Unit::none) return shortest(value);
  const Dimension& dimension = dimension_of(unit);
  std::string best = shortest(value) + " " + std::string(dimension.symbols.front().text);
  // "2 deg" rather than "0.03490658503988659 rad", where it means the very same bits
  for (const Symbol& symbol : dimension.symbols) {
    if (!symbol.in_degrees || symbol.per != 1.0) continue;
    for (int digits = 1; digits <= 17; ++digits) {
      const std::string text = fmt::format("{:.{}g}", degrees(value), digits);
      const std::string candidate = text + " " + std::string(symbol.text);
      if (candidate.size() >= best.size()) continue;
      double number = 0.0;
      (void)parse_number(text, number);
      if (in_si(number, symbol) == value) best = candidate;
    }
  }
  return best;
}

std::string unit_name(Unit unit) {
  if (unit == Unit::none) return "number";
  const Dimension& dimension = dimension_of(unit);
  return std::string(dimension.noun) + " [" + std::string(dimension.symbols.front().text) + "]";
}

std::string unit_symbol(Unit unit) {
  return unit == Unit::none ? "" : std::string(dimension_of(unit).symbols.front().text);
}

Unit unit_of_symbol(std::string_view symbol, const SourceLocation& place) {
  if (symbol.empty()) return Unit::none;
  for (const Dimension& dimension : dimensions()) {
    if (dimension.symbols.front().text == symbol) return dimension.unit;
  }
  throw InputError(place, in_quotes(symbol) + " is not the symbol of a unit");
}

double displayed(double value, Unit unit) {
  return display_symbol_of(unit) == nullptr ? value : value * 180.0 / kPi;
}

std::string display_symbol(Unit unit) {
  const Symbol* in_degrees = display_symbol_of(unit);
  return in_degrees == nullptr ? unit_symbol(unit) : std::string(in_degrees->text);
}

}  // namespace mapbed
