#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

// Where the beams of a laser point, and who says so.

namespace mapbed {

struct LogOptions;

struct Bearings {
  double first = 0.0;  // [rad] of the first beam
  double step = 0.0;   // [rad] from one beam to the next; negative: clockwise
  friend bool operator==(const Bearings&, const Bearings&) = default;
};

// A beam after the last would be the first one again, within half a step.
bool is_full_circle(const Bearings& bearings, std::size_t beams);

// A field of view, a step and a number of beams that fit each other: the field of view is that from
// the first beam to the last, or a step more, as programs understand it; one beam cut off is let
// pass.
bool fit(double field_of_view, double step, std::size_t beams);

// What the log says of a laser: PARAM lines, in which units are mixed up.
struct StatedBearings {
  std::optional<double> resolution;     // as it stands there
  std::optional<double> field_of_view;  // the same
  std::optional<double> first;          // [rad] our own parameter, of lasers that look to one side
};

// The bearings of the scans of one laser that have a number of beams.
struct BearingsInLog {
  std::optional<Bearings> bearings;  // none: nobody knows
  std::string source;                // "PARAM", "number of beams", "option field_of_view", …
  // What the log leaves possible beside these; none where it is stated and nothing contradicts.
  std::vector<Bearings> candidates;
  std::string note;  // what is odd about the statements; empty: nothing
};

// The options win, then what is stated, then the number of beams as the lasers of CARMEN logs have
// it, counter-clockwise:
//
//   180, 181    1    deg from  -90 deg        401           0.25 deg from  -50 deg
//   360, 361    0.5  deg from  -90 deg        720, 721      0.25 deg from  -90 deg
//   540, 541    0.5  deg from -135 deg        1080, 1081    0.25 deg from -135 deg
//   681, 682    360/1024 deg                  1440, 1441    0.25 deg from -180 deg
//
// With 180 beams the last one is thus at +89 deg: CARMEN cuts the 181st beam of the scanner off.
//
// Each replaces its own quantity alone; a field of view is both, the first bearing and the step,
// and a circle of an even number of beams has a step more than a beam's gaps. Statements are in
// degrees; where they fit only as radians they are taken as these. A number of beams alone also
// leaves the full circle possible, from the back or from the front.
BearingsInLog bearings_of(std::size_t beams, const StatedBearings& stated,
                          const LogOptions& options);

// Of a scan of nearly as many beams (5 %) as the laser's other scans have: the same circle divided
// by another number, or the same beams with some cut off at the end, or more of them. None: a scan
// of another kind.
std::optional<Bearings> bearings_of_neighbour(std::size_t beams, const Bearings& usual,
                                              std::size_t usual_beams);

// Of a scan whose line states its geometry: each option replaces its own quantity alone. Only a
// field of view is both, the first bearing and the step.
Bearings replaced_bearings(Bearings stated, std::size_t beams, const LogOptions& options);

// "option field_of_view, first_bearing": those of them that are set; empty: none is.
std::string names_of_bearing_options(const LogOptions& options);

// What a line says that states first bearing, field of view [0: not told] and step [0: not told].
// Numbers that are impossible as radians are taken as degrees; where the field of view and the
// step do not fit each other, the step counts and `other` is what the field of view would mean.
struct LineBearings {
  Bearings bearings;
  std::optional<Bearings> other;
  std::string note;  // what is odd; empty: nothing
};
LineBearings bearings_of_line(double first, double field_of_view, double step, std::size_t beams);

// "0.5 deg from -90 deg"
std::string to_string(const Bearings& bearings);

}  // namespace mapbed
