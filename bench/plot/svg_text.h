#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace mapbed {

// Text as it may stand in XML and HTML, in attributes too; control characters become blanks and
// bytes that are no UTF-8 become U+FFFD, so that no text makes a file that is not well formed.
std::string xml_escaped(std::string_view text);

// A coordinate with at most two digits after the point: "12", "0.25".
std::string coordinate(double value);

enum class FontWeight { regular, bold };

// How wide a line of text is at most, in units of `font_size`, whichever sans serif font a browser
// takes: DejaVu Sans and Verdana are a fifth wider than Helvetica.
double svg_text_width(std::string_view text, double font_size,
                      FontWeight weight = FontWeight::regular);

// `font_size`, or as much less as it takes for the line to be no wider than `width`.
double fitting_size(std::string_view text, double font_size, double width,
                    FontWeight weight = FontWeight::regular);

// Lines no wider than `width` where the words allow it; "\n" begins a new line.
std::vector<std::string> wrapped(std::string_view text, double font_size, double width,
                                 FontWeight weight = FontWeight::regular);

std::string base64(std::string_view bytes);

// "data:image/png;base64,..."
std::string png_address(std::string_view png);

// FNV-1a: for names of things within a file that must differ from those of another file.
std::uint64_t hash_of(std::string_view text);

}  // namespace mapbed
