#pragma once

#include <string>
#include <string_view>

#include "core/image/image.h"
#include "core/image/samples.h"

namespace mapbed {

// The picture as the bytes of a PNG file, 8 bits a channel; the same bytes for the same picture.
// It has at least one pixel. Reading: core/image/samples.h.
std::string png_of(const GrayImage& image);
std::string png_of(const RgbImage& image);

// Complete or not at all, see AtomicFile.
void write_png(const std::string& path, const GrayImage& image);
void write_png(const std::string& path, const RgbImage& image);

// Any kind of PNG; 8 or 16 bits a channel come out. Throws InputError where the bytes are no PNG,
// damaged, cut short or more than 2^26 pixels; `name` stands in errors.
Samples samples_from_png(std::string_view png, const std::string& name);

}  // namespace mapbed
