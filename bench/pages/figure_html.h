#pragma once

#include <string>
#include <string_view>

namespace mapbed {

// Whether an SVG file is one picture of shapes and texts alone, as plots are: elements and
// attributes that draw, no script, style sheet, event, animation or link out of the file. Only such
// text may become part of a page, as it would have the page's rights there.
bool is_plain_drawing(std::string_view svg);

// A figure for a page: part of it where it is a plain drawing, an image that a browser shows
// without running anything in it otherwise.
std::string figure_html(std::string_view svg);

}  // namespace mapbed
