#include "core/config/permitted_values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/config/option.h"
#include "core/config/quantity.h"

namespace mapbed {
namespace {

thread_local bool are_shown = false;

std::string shown(double value, Unit unit) {
  const std::string symbol = display_symbol(unit);
  return fmt::format("{:.6g}{}{}", displayed(value, unit), symbol.empty() ? "" : " ", symbol);
}

std::string within(const Bounds& bounds, Unit unit) {
  const Bounds widest = finite_bounds(unit, kAnyValue);
  const bool has_low = bounds.low > widest.low;
  const bool has_high = bounds.high < widest.high;
  const std::string low = shown(bounds.low, unit);
  const std::string high = shown(bounds.high, unit);
  if (has_low && has_high) {
    return fmt::format("{} {} to {}", bounds.low_itself ? "from" : "above", low, high);
  }
  if (has_low) return bounds.low_itself ? low + " or more" : "above " + low;
  return has_high ? high + " or less" : "";
}

bool is_number(const OptionValue& value) {
  return std::holds_alternative<double*>(value) || std::holds_alternative<int*>(value) ||
         std::holds_alternative<std::vector<double>*>(value) ||
         std::holds_alternative<std::vector<int>*>(value);
}

}  // namespace

std::string permitted_values(const Option& option) {
  if (const auto* choice = std::get_if<Choice>(&option.value)) {
    return fmt::format("one of {}", fmt::join(choice->names, ", "));
  }
  if (std::holds_alternative<bool*>(option.value)) return "true or false";
  return is_number(option.value) ? within(option.bounds, option.unit) : "";
}

PermittedValuesShown::PermittedValuesShown() : before_(are_shown) {
  are_shown = true;
}

PermittedValuesShown::~PermittedValuesShown() {
  are_shown = before_;
}

bool PermittedValuesShown::now() {
  return are_shown;
}

}  // namespace mapbed
