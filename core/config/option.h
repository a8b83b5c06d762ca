#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

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
  newton,
};

// A choice by name: the value is one of `names`.
struct Choice {
  int* value;  // index into names
  std::vector<std::string> names;
};

// One option of a struct, by reference: path, place in memory, unit and meaning. Reading, writing,
// sweeping by dotted path, describing and rejecting unknown keys all work on a list of these.
struct Option {
  std::string path;  // "first_step", "odometry.rotation_sigma"
  std::variant<double*, int*, std::uint64_t*, bool*, std::string*, std::vector<double>*,
               std::vector<std::string>*, Choice>
      value;
  Unit unit = Unit::none;
  std::string about;
};

using OptionList = std::vector<Option>;

// Every options struct lists its fields once, in a free function beside it:
//
//   template <class Visitor>
//   void visit_fields(ScanMatcherOptions& o, Visitor&& visit) {
//     visit("first_step", o.first_step, Unit::meter, "first step of the search");
//     visit("field", o.field, "the smoothed map that is matched against");        // a nested
//     struct
//   }
//
// An enum is visited as an int with its names: visit("model", o.model, {"odds", "counting"}, "…").
namespace option_detail {

class Collector {
 public:
  Collector(OptionList& list, std::string prefix) : list_(list), prefix_(std::move(prefix)) {}

  template <class T>
  void operator()(std::string_view name, T& field, Unit unit, std::string_view about) {
    list_.push_back({prefix_ + std::string(name), &field, unit, std::string(about)});
  }

  template <class T>
  void operator()(std::string_view name, T& field, std::string_view about) {
    if constexpr (requires { visit_fields(field, *this); }) {
      Collector inner(list_, prefix_ + std::string(name) + ".");
      visit_fields(field, inner);
    } else {
      (*this)(name, field, Unit::none, about);
    }
  }

  template <class Enum>
  requires std::is_enum_v<Enum>
  void operator()(std::string_view name, Enum& field, std::vector<std::string> names,
                  std::string_view about) {
    static_assert(std::is_same_v<std::underlying_type_t<Enum>, int>);
    list_.push_back({prefix_ + std::string(name),
                     Choice{reinterpret_cast<int*>(&field), std::move(names)}, Unit::none,
                     std::string(about)});
  }

 private:
  OptionList& list_;
  std::string prefix_;
};

}  // namespace option_detail

// All options of a struct; the pointers live as long as the struct.
template <class Options>
OptionList options_of(Options& options) {
  OptionList list;
  option_detail::Collector collect(list, "");
  visit_fields(options, collect);
  return list;
}

}  // namespace mapbed
