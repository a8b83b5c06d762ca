#pragma once

#include <string>

#include "core/image/image.h"

namespace mapbed {

// A picture as a PDF file of one page of its shape, `width` wide [mm]; the same bytes for the same
// picture. Its pixels are kept as they are, without loss. It has at least one.
std::string pdf_of(const RgbImage& image, double width);

}  // namespace mapbed
