#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/config/bounds.h"
#include "core/config/unit.h"

namespace mapbed {

// A choice by name: the field is of an enum, its value the index of one of `names`.
struct Choice {
  void* field;
  int (*get)(const void* field);
  void (*set)(void* field, int value);
  std::vector<std::string> names;
};

using OptionValue =
    std::variant<double*, int*, std::uint64_t*, bool*, std::string*, std::vector<double>*,
                 std::vector<int>*, std::vector<std::string>*, Choice>;

// The same with an end where `bounds` name none: the largest values of the unit that make sense, as
// 10 km, so that no number is so large that work with it never ends. Seeds may be any number.
Bounds finite_bounds(Unit unit, const Bounds& bounds);

// One option of a struct, by reference: path, place in memory, unit, bounds and meaning. Reading,
// writing, sweeping by dotted path, describing and rejecting unknown keys all work on a list of
// these. Default values are finite and within their bounds.
struct Option {
  std::string path;  // "first_step", "odometry.rotation_sigma"
  OptionValue value;
  Unit unit = Unit::none;
  Bounds bounds;
  std::string about;
};

using OptionList = std::vector<Option>;

// Every options struct lists its fields once, in a free function beside it:
//
//   template <class Visitor>
//   void visit_fields(ScanMatcherOptions& o, Visitor&& visit) {
//     visit("first_step", o.first_step, Unit::meter, kPositive, "first step of the search");
//     visit("max_beams", o.max_beams, at_least(1), "beams used of a scan");
//     visit("model", o.model, {"odds", "counting"}, "how a cell is judged");   // an enum
//     visit("field", o.field, "the smoothed map that is matched against");     // a nested struct
//   }
//
// Unit and bounds may be left out, the meaning may not. A value out of bounds is an InputError with
// the place where it was written.
namespace option_detail {

class Collector {
 public:
  Collector(OptionList& list, std::string prefix);

  template <class T>
  void operator()(std::string_view name, T& field, Unit unit, const Bounds& bounds,
                  std::string_view about) {
    add(name, &field, unit, bounds, about);
  }

  template <class T>
  void operator()(std::string_view name, T& field, Unit unit, std::string_view about) {
    (*this)(name, field, unit, kAnyValue, about);
  }

  template <class T>
  void operator()(std::string_view name, T& field, const Bounds& bounds, std::string_view about) {
    (*this)(name, field, Unit::none, bounds, about);
  }

  template <class T>
  void operator()(std::string_view name, T& field, std::string_view about) {
    if constexpr (requires { visit_fields(field, *this); }) {
      Collector inner(list_, prefix_ + std::string(name) + ".");
      visit_fields(field, inner);
    } else {
      (*this)(name, field, Unit::none, kAnyValue, about);
    }
  }

  template <class Enum>
  requires std::is_enum_v<Enum>
  void operator()(std::string_view name, Enum& field, std::vector<std::string> names,
                  std::string_view about) {
    add(name,
        Choice{&field, [](const void* f) { return static_cast<int>(*static_cast<const Enum*>(f)); },
               [](void* f, int value) { *static_cast<Enum*>(f) = static_cast<Enum>(value); },
               std::move(names)},
        Unit::none, kAnyValue, about);
  }

 private:
  void add(std::string_view name, OptionValue value, Unit unit, const Bounds& bounds,
           std::string_view about);

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
