#include "core/log/bearings.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/geometry/angle.h"
#include "core/log/log_options.h"

namespace mapbed {
namespace {

constexpr double kCircle = 2.0 * kPi;

// Fewer degrees than any laser with ten beams covers: the number is one of radians.
constexpr double kNarrowest = 10.0;  // [deg]
constexpr std::size_t kFewBeams = 10;

double gaps(std::size_t beams) {
  return static_cast<double>(beams - 1);
}

// 0: no laser that we know.
double usual_step(std::size_t beams) {
  switch (beams) {
    case 180:
    case 181:
      return radians(1.0);
    case 360:
    case 361:
    case 540:
    case 541:
      return radians(0.5);
    case 401:
    case 720:
    case 721:
    case 1080:
    case 1081:
    case 1440:
    case 1441:
      return radians(0.25);
    case 681:
    case 682:
      return radians(360.0 / 1024.0);
    default:
      return 0.0;
  }
}

// An even number of beams is one cut off an odd one: 180 of 181.
double usual_first(std::size_t beams, double step) {
  return -0.5 * step * static_cast<double>(beams % 2 == 0 ? beams : beams - 1);
}

// Of beams that cover a field of view; those of a full circle are not to meet at its end.
double step_of(double field_of_view, std::size_t beams) {
  const bool meets = field_of_view > kCircle - 1e-3 && beams % 2 == 0;
  return field_of_view / (meets ? static_cast<double>(beams) : gaps(beams));
}

// Statements in radians.
struct Statements {
  std::optional<double> step;
  std::optional<double> field_of_view;
  bool contradict = false;
  std::string note;
};

Statements in_units(const std::optional<double>& step, const std::optional<double>& field_of_view,
                    bool step_in_radians, bool field_in_radians) {
  Statements result;
  if (step) result.step = step_in_radians ? *step : radians(*step);
  if (field_of_view)
    result.field_of_view = field_in_radians ? *field_of_view : radians(*field_of_view);
  if (step && step_in_radians)
    result.note =
        fmt::format("resolution {:g} is taken as radians ({:.4g} deg)", *step, degrees(*step));
  if (field_of_view && field_in_radians)
    result.note +=
        fmt::format("{}fov {:g} is taken as radians ({:.4g} deg)", result.note.empty() ? "" : ", ",
                    *field_of_view, degrees(*field_of_view));
  return result;
}

bool possible(double field_of_view) {
  return field_of_view > 0.0 && field_of_view <= kCircle + 1e-2;
}

// Degrees where they make sense, else radians, each of the two statements for itself.
Statements statements_of(const StatedBearings& stated, std::size_t beams) {
  const auto& step = stated.resolution;
  const auto& field = stated.field_of_view;
  constexpr std::array<std::array<bool, 2>, 4> kUnits = {
      {{false, false}, {false, true}, {true, true}, {true, false}}};
  if (step && field) {
    for (const auto& [step_in_radians, field_in_radians] : kUnits) {
      Statements s = in_units(step, field, step_in_radians, field_in_radians);
      const bool wide = beams < kFewBeams || *s.field_of_view >= radians(kNarrowest);
      if (wide && possible(*s.field_of_view) && fit(*s.field_of_view, *s.step, beams)) return s;
    }
  }
  const bool many = beams >= kFewBeams;
  const bool step_in_radians =
      many && step && *step * gaps(beams) < kNarrowest && possible(*step * gaps(beams));
  const bool field_in_radians = many && field && *field < kNarrowest && possible(*field);
  Statements result = in_units(step, field, step_in_radians, field_in_radians);
  const auto drop = [&result](std::optional<double>& value, const char* name, double was) {
    value.reset();
    result.note += fmt::format("{}{} {:g} makes no sense and is not used",
                               result.note.empty() ? "" : ", ", name, was);
  };
  if (result.step && !possible(*result.step * gaps(beams))) drop(result.step, "resolution", *step);
  if (result.field_of_view && !possible(*result.field_of_view))
    drop(result.field_of_view, "fov", *field);
  result.contradict = result.step && result.field_of_view;
  return result;
}

// Who is right where the two do not fit: the one that a laser of so many beams has.
void settle(const Statements& s, std::size_t beams, BearingsInLog& result) {
  const double usual = usual_step(beams);
  const Bearings by_step{usual_first(beams, *s.step), *s.step};
  const Bearings by_field{-0.5 * *s.field_of_view, step_of(*s.field_of_view, beams)};
  if (usual != 0.0 && fit(*s.field_of_view, usual, beams)) {
    result.bearings = Bearings{by_field.first, usual};
    result.candidates = {by_step};
  } else {
    result.bearings = Bearings{by_field.first, *s.step};
    result.candidates = {by_step, by_field};
  }
  result.note +=
      fmt::format("{}resolution {:g} deg and fov {:g} deg do not fit {} beams: {} is taken",
                  result.note.empty() ? "" : ", ", degrees(*s.step), degrees(*s.field_of_view),
                  beams, to_string(*result.bearings));
}

void guess(std::size_t beams, BearingsInLog& result) {
  result.source = fmt::format("the number of beams, {}", beams);
  const double circle_step = kCircle / static_cast<double>(beams);
  if (beams >= kFewBeams) result.candidates = {{-kPi, circle_step}, {0.0, circle_step}};
  const double step = usual_step(beams);
  if (step == 0.0) return;
  result.bearings = Bearings{usual_first(beams, step), step};
  std::erase(result.candidates, *result.bearings);
}

void read_statements(const StatedBearings& stated, std::size_t beams, BearingsInLog& result) {
  const Statements s = statements_of(stated, beams);
  result.note = s.note;
  if (!s.step && !s.field_of_view) return guess(beams, result);
  result.source = "PARAM";
  if (stated.first && s.step) {
    result.bearings = Bearings{*stated.first, *s.step};
  } else if (s.contradict) {
    settle(s, beams, result);
  } else if (!s.field_of_view) {
    result.bearings = Bearings{usual_first(beams, *s.step), *s.step};
  } else {
    const double usual = usual_step(beams);
    const bool usual_fits = usual != 0.0 && fit(*s.field_of_view, usual, beams);
    result.bearings =
        Bearings{-0.5 * *s.field_of_view, s.step       ? *s.step
                                          : usual_fits ? usual
                                                       : step_of(*s.field_of_view, beams)};
  }
}

}  // namespace

std::string names_of_bearing_options(const LogOptions& options) {
  std::string names;
  const auto add = [&names](bool is_set, const char* name) {
    if (is_set) names += (names.empty() ? "option " : ", ") + std::string(name);
  };
  add(options.field_of_view > 0.0, "field_of_view");
  add(!options.first_bearing.empty(), "first_bearing");
  add(options.bearing_step != 0.0, "bearing_step");
  return names;
}

bool is_full_circle(const Bearings& bearings, std::size_t beams) {
  const double step = std::abs(bearings.step);
  return std::abs(step * static_cast<double>(beams) - kCircle) < 0.5 * step;
}

bool fit(double field_of_view, double step, std::size_t beams) {
  const double difference = field_of_view - step * gaps(beams);
  const double slack = 1e-3 * field_of_view;
  return difference > -1.01 * step - slack && difference < 2.01 * step + slack;
}

Bearings replaced_bearings(Bearings stated, std::size_t beams, const LogOptions& options) {
  if (options.field_of_view > 0.0 && beams > 1)
    stated = {-0.5 * options.field_of_view, step_of(options.field_of_view, beams)};
  if (options.bearing_step != 0.0) stated.step = options.bearing_step;
  if (!options.first_bearing.empty()) stated.first = options.first_bearing[0];
  return stated;
}

BearingsInLog bearings_of(std::size_t beams, const StatedBearings& stated,
                          const LogOptions& options) {
  BearingsInLog result;
  if (beams < 2) return result;
  read_statements(stated, beams, result);
  const std::string names = names_of_bearing_options(options);
  if (names.empty()) return result;
  const bool is_stated = result.source == "PARAM";
  result.source = names + (result.source.empty() ? "" : ", else " + result.source);
  if (options.bearing_step != 0.0 && !is_stated) {
    // A guess at the first bearing was one at the step.
    result.bearings = Bearings{-0.5 * options.bearing_step * gaps(beams), options.bearing_step};
  }
  const bool sets_step = options.bearing_step != 0.0 || options.field_of_view > 0.0;
  if (!result.bearings && !sets_step) return result;
  result.bearings = replaced_bearings(result.bearings.value_or(Bearings{}), beams, options);
  std::vector<Bearings> candidates;
  for (Bearings other : sets_step ? std::vector<Bearings>{} : result.candidates) {
    other = replaced_bearings(other, beams, options);
    const bool is_new = std::find(candidates.begin(), candidates.end(), other) == candidates.end();
    if (is_new && other != *result.bearings) candidates.push_back(other);
  }
  result.candidates = std::move(candidates);
  return result;
}

std::optional<Bearings> bearings_of_neighbour(std::size_t beams, const Bearings& usual,
                                              std::size_t usual_beams) {
  const double difference = static_cast<double>(beams) - static_cast<double>(usual_beams);
  if (std::abs(difference) > 0.05 * static_cast<double>(usual_beams)) return std::nullopt;
  if (!is_full_circle(usual, usual_beams)) return usual;
  return Bearings{usual.first, std::copysign(kCircle, usual.step) / static_cast<double>(beams)};
}

LineBearings bearings_of_line(double first, double field_of_view, double step, std::size_t beams) {
  constexpr double kMost = kCircle + 2e-2;
  std::string in_degrees;
  const auto to_radians = [&in_degrees](double& value, double extent, const char* name) {
    if (std::abs(extent) <= kMost) return;
    value = radians(value);
    in_degrees += (in_degrees.empty() ? "" : ", ") + std::string(name);
  };
  const bool many = beams >= kFewBeams;
  to_radians(first, first, "first bearing");
  to_radians(field_of_view, field_of_view, "field of view");
  to_radians(step, many ? step * gaps(beams) : 0.0, "step");
  LineBearings result;
  if (!in_degrees.empty()) result.note = in_degrees + " taken as degrees, too large for radians";
  const double by_field = beams > 1 ? field_of_view / gaps(beams) : 0.0;
  result.bearings = {first, step == 0.0 ? by_field : step};
  if (step == 0.0 || field_of_view == 0.0 || !many) return result;
  if (fit(std::abs(field_of_view), std::abs(step), beams)) return result;
  result.other = Bearings{first, std::copysign(by_field, step)};
  if (result.note.empty())
    result.note = "field of view and step do not fit the number of beams: the step is taken";
  return result;
}

std::string to_string(const Bearings& bearings) {
  return fmt::format("{:.5g} deg from {:.5g} deg", degrees(bearings.step), degrees(bearings.first));
}

}  // namespace mapbed
