#include "core/labels/labels_file.h"

#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "core/file/text_file.h"
#include "core/file/tokens.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr std::string_view kHeader = "# MAPBED LABELS 1";

ScanLabels parse_line(std::string_view line, const SourceLocation& place) {
  Tokens tokens(line);
  ScanLabels labels;
  labels.time = tokens.number();
  const double laser = tokens.number();
  const std::size_t beams = tokens.count();
  if (!tokens.ok() || !std::isfinite(labels.time) || laser != std::floor(laser) || laser < 0.0 ||
      laser > 1e6) {
    throw InputError(place, "a line of labels begins with a time, a laser and a number of beams");
  }
  labels.laser = static_cast<int>(laser);
  labels.static_probability.reserve(beams);
  for (std::size_t beam = 0; beam < beams; ++beam) {
    std::string_view rest = tokens.rest();
    if (next_word(rest) == "-") {
      tokens.word();
      labels.static_probability.push_back(kNoLabel);
      continue;
    }
    const double percent = tokens.number();
    if (!tokens.ok() || !(percent >= 0.0 && percent <= 100.0)) {
      throw InputError(place,
                       fmt::format("label {} of {} is neither 0 to 100 nor '-'", beam + 1, beams));
    }
    labels.static_probability.push_back(static_cast<float>(percent / 100.0));
  }
  if (!tokens.at_end()) {
    throw InputError(place, fmt::format("has more than the {} labels that it says", beams));
  }
  return labels;
}

}  // namespace

void write_labels(const std::string& path, const BeamLabels& labels_of_lasers) {
  std::string text =
      fmt::format("{}\n# time laser beams, percent that each is of the place\n", kHeader);
  for (const ScanLabels& scan : labels_of_lasers) {
    fmt::format_to(std::back_inserter(text), "{:.6f} {} {}", scan.time, scan.laser,
                   scan.static_probability.size());
    for (const float p : scan.static_probability) {
      if (std::isnan(p)) {
        text += " -";
      } else {
        // Rounded away from one half, so that who reads it finds the same beams dynamic.
        const double percent = 100.0 * static_cast<double>(p);
        const int whole = static_cast<int>(std::lround(percent));
        fmt::format_to(std::back_inserter(text), " {}", is_dynamic(p) && whole == 50 ? 49 : whole);
      }
    }
    text += '\n';
  }
  write_text_file(path, text);
}

BeamLabels parse_labels(const std::string& name, std::string_view text) {
  BeamLabels labels;
  for (int line_number = 1; !text.empty(); ++line_number) {
    const std::string_view line = without_blanks(next_line(text));
    if (line_number == 1 && line != kHeader) {
      throw InputError({name, 1},
                       fmt::format("is no file of labels: it does not begin with '{}'", kHeader));
    }
    if (line.empty() || line.front() == '#') continue;
    labels.push_back(parse_line(line, {name, line_number}));
  }
  if (labels.empty()) throw InputError({name}, "has no labels");
  return labels;
}

BeamLabels load_labels(const std::string& path) {
  return parse_labels(path, read_text_file(path));
}

}  // namespace mapbed
