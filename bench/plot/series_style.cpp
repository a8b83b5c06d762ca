#include "bench/plot/series_style.h"

#include <array>

#include <fmt/format.h>

#include "bench/plot/svg_text.h"
#include "core/check.h"
#include "core/image/color_map.h"

namespace mapbed {
namespace {

// Of categorical_color(): blue, vermilion, green, orange, purple, sky blue, black; yellow is too
// light on white. Neighbours differ in lightness.
constexpr std::array<int, 7> kOrder = {5, 1, 3, 6, 0, 2, 7};

constexpr std::array<const char*, 5> kDashes = {"", "7 3", "2 2.5", "9 3 2 3", "12 4"};

// Disc, square, triangle, diamond, triangle upside down, plus.
constexpr std::array<const char*, 6> kMarkers = {
    "M-3.5 0a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0 -7 0z",
    "M-3.2 -3.2h6.4v6.4h-6.4z",
    "M0 -4.2L4 3.2H-4z",
    "M0 -4.6L4 0L0 4.6L-4 0z",
    "M0 4.2L4 -3.2H-4z",
    "M-1.2 -4h2.4v2.8h2.8v2.4h-2.8v2.8h-2.4v-2.8h-2.8v-2.4h2.8z"};

// Lines in a tile of 6 by 6 px: none, rising, falling, crossed, level, upright, dots.
constexpr std::array<const char*, 7> kHatchings = {"",
                                                   "M-1 1L1 -1M0 6L6 0M5 7L7 5",
                                                   "M-1 5L1 7M0 0L6 6M5 -1L7 1",
                                                   "M0 6L6 0M0 0L6 6",
                                                   "M0 3H6",
                                                   "M3 0V6",
                                                   "M2 2h2v2h-2z"};

template <class Values>
auto cycled(const Values& values, int index) {
  return values[static_cast<std::size_t>(index) % values.size()];
}

}  // namespace

SeriesStyle series_style(int index) {
  CHECK(index >= 0);
  const Rgb rgb = categorical_color(cycled(kOrder, index));
  return {fmt::format("#{:02x}{:02x}{:02x}", rgb.red, rgb.green, rgb.blue), cycled(kDashes, index),
          cycled(kMarkers, index), index % 2 == 0, index % static_cast<int>(kHatchings.size())};
}

std::string marker_at(const SeriesStyle& style, double x, double y) {
  return fmt::format(
      "<path transform=\"translate({} {})\" d=\"{}\" fill=\"{}\" stroke=\"{}\" "
      "stroke-width=\"1.2\"/>\n",
      coordinate(x), coordinate(y), style.marker, style.filled ? style.color : "#fff", style.color);
}

std::string hatching_of(const SeriesStyle& style, const std::string& id) {
  const std::string lines = kHatchings[static_cast<std::size_t>(style.hatching)];
  return fmt::format(
      "<pattern id=\"{0}\" width=\"6\" height=\"6\" patternUnits=\"userSpaceOnUse\">"
      "<rect width=\"6\" height=\"6\" fill=\"{1}\" fill-opacity=\"{2}\"/>"
      "<path d=\"{3}\" stroke=\"{1}\" stroke-width=\"1.3\" fill=\"none\"/></pattern>\n",
      id, style.color, style.hatching == 0 ? 1.0 : 0.3, lines);
}

std::string legend_symbol(const SeriesStyle& style, Mark mark, bool band,
                          const std::string& hatching) {
  if (mark == Mark::bars) {
    return fmt::format("<rect x=\"4\" width=\"20\" height=\"12\" fill=\"url(#{})\" stroke=\"{}\"/>",
                       hatching, style.color);
  }
  if (mark == Mark::path) {
    return fmt::format("<path d=\"M0 6H28\" stroke=\"{}\" stroke-width=\"1.2\"/>", style.color);
  }
  if (mark == Mark::dots) {
    return fmt::format(
        "<path d=\"M8 4h0M14 8h0M20 5h0\" stroke=\"{}\" stroke-width=\"2.6\" "
        "stroke-linecap=\"round\"/>",
        style.color);
  }
  std::string symbol;
  if (mark == Mark::line) {
    if (band) {
      symbol += fmt::format(
          "<rect y=\"1\" width=\"28\" height=\"10\" fill=\"{}\" "
          "fill-opacity=\"0.18\"/>",
          style.color);
    }
    symbol += fmt::format(
        "<path d=\"M0 6H28\" stroke=\"{}\" stroke-width=\"2\"{} fill=\"none\"/>", style.color,
        style.dash.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", style.dash));
  }
  return symbol + marker_at(style, 14.0, 6.0);
}

}  // namespace mapbed
