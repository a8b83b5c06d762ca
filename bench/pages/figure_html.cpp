#include "bench/pages/figure_html.h"

#include <algorithm>
#include <array>

#include "bench/plot/svg_text.h"
#include "core/file/tokens.h"

namespace mapbed {
namespace {

constexpr std::array<std::string_view, 17> kElements = {
    "svg",  "g",     "line",  "path", "rect",    "circle", "ellipse", "polyline", "polygon",
    "text", "tspan", "title", "desc", "pattern", "defs",   "image",   "clipPath"};

constexpr std::array<std::string_view, 54> kAttributes = {"xmlns",
                                                          "width",
                                                          "height",
                                                          "viewBox",
                                                          "role",
                                                          "class",
                                                          "id",
                                                          "x",
                                                          "y",
                                                          "x1",
                                                          "y1",
                                                          "x2",
                                                          "y2",
                                                          "dx",
                                                          "dy",
                                                          "cx",
                                                          "cy",
                                                          "r",
                                                          "rx",
                                                          "ry",
                                                          "d",
                                                          "points",
                                                          "transform",
                                                          "overflow",
                                                          "opacity",
                                                          "fill",
                                                          "fill-opacity",
                                                          "fill-rule",
                                                          "stroke",
                                                          "stroke-width",
                                                          "stroke-opacity",
                                                          "stroke-linecap",
                                                          "stroke-linejoin",
                                                          "stroke-dasharray",
                                                          "stroke-miterlimit",
                                                          "font-family",
                                                          "font-size",
                                                          "font-weight",
                                                          "font-style",
                                                          "text-anchor",
                                                          "dominant-baseline",
                                                          "patternUnits",
                                                          "patternTransform",
                                                          "patternContentUnits",
                                                          "clip-path",
                                                          "clipPathUnits",
                                                          "preserveAspectRatio",
                                                          "shape-rendering",
                                                          "image-rendering",
                                                          "aria-label",
                                                          "lang",
                                                          "version",
                                                          "style",
                                                          "href"};

template <class Names>
bool has(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// An address leads to nothing but a picture within it, a paint to a thing of the same file.
bool is_harmless(std::string_view name, std::string_view value) {
  if (name == "href") return value.starts_with("data:image/png;base64,");
  if (name == "style") return value == "image-rendering:pixelated";
  const std::size_t url = value.find("url(");
  return value.find('&') == value.npos && (url == value.npos || value.substr(url + 4, 1) == "#");
}

bool is_space(char c) {
  return is_blank(c) || c == '\n';
}

std::string_view name_at(std::string_view text) {
  const auto part_of_name = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
  };
  const auto end = std::find_if_not(text.begin(), text.end(), part_of_name);
  return text.substr(0, static_cast<std::size_t>(end - text.begin()));
}

// Cuts off `name="value"`; false where there is something else.
bool take_attribute(std::string_view& rest) {
  const std::string_view name = name_at(rest);
  rest.remove_prefix(name.size());
  if (!rest.starts_with("=\"")) return false;
  const std::size_t end = rest.find('"', 2);
  if (end == rest.npos) return false;
  const std::string_view value = rest.substr(2, end - 2);
  rest.remove_prefix(end + 1);
  return has(kAttributes, name) && value.find('<') == value.npos && is_harmless(name, value);
}

// Cuts off one tag with its "<" and ">". `depth` counts the elements that are open.
bool take_tag(std::string_view& rest, int& depth) {
  rest.remove_prefix(1);
  const bool closes = rest.starts_with('/');
  if (closes) rest.remove_prefix(1);
  const std::string_view name = name_at(rest);
  if (!has(kElements, name) || (depth == 0 && (closes || name != "svg"))) return false;
  rest.remove_prefix(name.size());
  for (;;) {
    const bool apart = !rest.empty() && is_space(rest[0]);
    while (!rest.empty() && is_space(rest[0])) rest.remove_prefix(1);
    if (rest.starts_with('>')) break;
    if (rest.starts_with("/>") && !closes) {
      rest.remove_prefix(2);
      return true;
    }
    if (closes || !apart || !take_attribute(rest)) return false;
  }
  rest.remove_prefix(1);
  depth += closes ? -1 : 1;
  return true;
}

}  // namespace

bool is_plain_drawing(std::string_view svg) {
  int depth = 0;
  int pictures = 0;
  while (!svg.empty()) {
    if (svg[0] != '<') {
      if (depth == 0 && !is_space(svg[0])) return false;
      svg.remove_prefix(1);
      continue;
    }
    if (depth == 0) ++pictures;
    if (!take_tag(svg, depth)) return false;
  }
  return depth == 0 && pictures == 1;
}

std::string figure_html(std::string_view svg) {
  if (is_plain_drawing(svg)) return std::string(svg);
  return "<img src=\"data:image/svg+xml;base64," + base64(svg) + "\" alt=\"figure\">\n";
}

}  // namespace mapbed
