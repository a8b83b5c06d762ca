#include "core/config/config_node.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/check.h"
#include "core/config/quantity.h"
#include "core/config/renamed_options.h"
#include "core/config/suggestion.h"
#include "core/config/yaml_scalar.h"

namespace mapbed {
namespace {

std::string kind_name(ConfigNode::Kind kind) {
  switch (kind) {
    case ConfigNode::Kind::value:
      return "one value";
    case ConfigNode::Kind::list:
      return "a list";
    case ConfigNode::Kind::map:
      return "keys with values";
  }
  return {};
}

std::string example_of(ConfigNode::Kind kind) {
  switch (kind) {
    case ConfigNode::Kind::value:
      return "write it without brackets and braces";
    case ConfigNode::Kind::list:
      return "write it as '[first, second]'";
    case ConfigNode::Kind::map:
      return "write it as '{key: value}'";
  }
  return {};
}

// As it may be written where it stands: a whole number has no exponent.
std::string bound_text(double bound, Unit unit, bool is_whole) {
  return is_whole ? fmt::format("{:.0f}", bound) : quantity_text(bound, unit);
}

// Comparisons are written so that every value lies within kAnyValue.
void check_bounds(double value, Unit unit, const Bounds& bounds, bool is_whole,
                  const std::string& text, const SourceLocation& place) {
  const bool too_low = bounds.low_itself ? value < bounds.low : value <= bounds.low;
  const bool too_high = value > bounds.high;
  if (!too_low && !too_high) return;
  std::string range;
  if (std::isfinite(bounds.low)) {
    range =
        (bounds.low_itself ? "at least " : "more than ") + bound_text(bounds.low, unit, is_whole);
  }
  if (std::isfinite(bounds.high)) {
    range +=
        (range.empty() ? "at most " : " and at most ") + bound_text(bounds.high, unit, is_whole);
  }
  throw InputError(place, in_quotes(text) + " is too " + (too_low ? "small" : "large"),
                   "it must be " + range);
}

template <class Integer>
Integer parse_integer(const std::string& text, const Bounds& bounds, const SourceLocation& place) {
  Integer value{};
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (error == std::errc::result_out_of_range) {
    throw InputError(place, in_quotes(text) + " is too large for a whole number");
  }
  if (error != std::errc() || end != last) {
    const bool sign = std::is_unsigned_v<Integer> && text.starts_with("-");
    throw InputError(place, in_quotes(text) + " is not a whole number",
                     sign ? "write e.g. '3', it cannot be negative" : "write e.g. '3'");
  }
  check_bounds(static_cast<double>(value), Unit::none, bounds, true, text, place);
  return value;
}

}  // namespace

ConfigNode::ConfigNode(std::string text, SourceLocation place)
    : kind_(Kind::value), place_(std::move(place)), text_(std::move(text)) {}

ConfigNode::ConfigNode(std::vector<ConfigNode> items, SourceLocation place)
    : kind_(Kind::list), place_(std::move(place)), children_(std::move(items)) {}

ConfigNode::ConfigNode(std::vector<std::string> keys, std::vector<ConfigNode> values,
                       SourceLocation place)
    : kind_(Kind::map),
      place_(std::move(place)),
      keys_(std::move(keys)),
      children_(std::move(values)) {
  CHECK(keys_.size() == children_.size());
}

void ConfigNode::expect(Kind kind) const {
  used_ = true;
  if (kind_ == kind) return;
  const std::string found = kind_ == Kind::value ? in_quotes(text_) : kind_name(kind_);
  throw InputError(place_, found + " stands where " + kind_name(kind) + " should be",
                   example_of(kind));
}

const std::string& ConfigNode::text() const {
  expect(Kind::value);
  return text_;
}

double ConfigNode::number(Unit unit, const Bounds& bounds) const {
  const double value = parse_quantity(text(), unit, place_);
  check_bounds(value, unit, finite_bounds(unit, bounds), false, text_, place_);
  return value;
}

int ConfigNode::whole_number(const Bounds& bounds) const {
  return parse_integer<int>(text(), finite_bounds(Unit::none, bounds), place_);
}

std::uint64_t ConfigNode::unsigned_number(const Bounds& bounds) const {
  return parse_integer<std::uint64_t>(text(), bounds, place_);
}

bool ConfigNode::flag() const {
  if (text() == "true") return true;
  if (text_ == "false") return false;
  throw InputError(place_, in_quotes(text_) + " is neither yes nor no", "write 'true' or 'false'");
}

int ConfigNode::choice(const std::vector<std::string>& names) const {
  const auto found = std::find(names.begin(), names.end(), text());
  if (found == names.end()) {
    throw InputError(place_, in_quotes(text_) + " is not a choice here", suggestion(text_, names));
  }
  return static_cast<int>(found - names.begin());
}

const std::vector<ConfigNode>& ConfigNode::items() const {
  expect(Kind::list);
  for (const ConfigNode& item : children_) item.used_ = true;
  return children_;
}

std::vector<std::string> ConfigNode::texts() const {
  std::vector<std::string> result;
  for (const ConfigNode& item : items()) result.push_back(item.text());
  return result;
}

std::vector<double> ConfigNode::numbers(Unit unit, const Bounds& bounds) const {
  std::vector<double> result;
  for (const ConfigNode& item : items()) result.push_back(item.number(unit, bounds));
  return result;
}

std::vector<int> ConfigNode::whole_numbers(const Bounds& bounds) const {
  std::vector<int> result;
  for (const ConfigNode& item : items()) result.push_back(item.whole_number(bounds));
  return result;
}

const ConfigNode* ConfigNode::find(std::string_view key) const {
  expect(Kind::map);
  if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) asked_.emplace_back(key);
  const auto found = std::find(keys_.begin(), keys_.end(), key);
  if (found == keys_.end()) return nullptr;
  const ConfigNode& child = children_[static_cast<std::size_t>(found - keys_.begin())];
  child.used_ = true;
  return &child;
}

const ConfigNode& ConfigNode::at(std::string_view key) const {
  const ConfigNode* const child = find(key);
  if (child != nullptr) return *child;
  const std::string meant = nearest(key, keys_);
  throw InputError(place_, "key " + in_quotes(key) + " is missing",
                   meant.empty() ? "" : "is " + in_quotes(meant) + " meant to be it?");
}

const std::vector<std::string>& ConfigNode::keys() const {
  expect(Kind::map);
  for (const ConfigNode& child : children_) child.used_ = true;
  asked_ = keys_;
  return keys_;
}

void ConfigNode::check_all_used(const std::string& context) const {
  for (std::size_t i = 0; i < children_.size(); ++i) {
    const ConfigNode& child = children_[i];
    const std::string key = kind_ == Kind::map ? keys_[i] : "[" + std::to_string(i) + "]";
    if (!child.used_) {
      const std::string whole = context.empty() ? key : context + "." + key;
      if (const auto renaming = renaming_of(whole, {})) throw InputError(child.place_, *renaming);
      const std::string reason =
          kind_ == Kind::map ? "unknown key " + in_quotes(key) : "unused entry";
      throw InputError(child.place_, reason + (context.empty() ? "" : " in " + context),
                       kind_ == Kind::map ? suggestion(key, asked_) : "");
    }
    const bool dot = kind_ == Kind::map && !context.empty();
    child.check_all_used(context + (dot ? "." : "") + key);
  }
}

void ConfigNode::use_all() const {
  used_ = true;
  asked_ = keys_;
  for (const ConfigNode& child : children_) child.use_all();
}

std::string ConfigNode::flow_text() const {
  if (kind_ == Kind::value) return text_;
  std::string result;
  for (std::size_t i = 0; i < children_.size(); ++i) {
    const ConfigNode& child = children_[i];
    if (i > 0) result += ", ";
    if (kind_ == Kind::map) result += yaml_scalar(keys_[i]) + ": ";
    result += child.kind_ == Kind::value ? yaml_scalar(child.text_) : child.flow_text();
  }
  return kind_ == Kind::list ? "[" + result + "]" : "{" + result + "}";
}

}  // namespace mapbed
