#pragma once

#include <string>
#include <string_view>

#include "core/image/image.h"

namespace mapbed {

// The picture as the bytes of a PNG file, 8 bits a channel; the same bytes for the same picture.
// It has at least one pixel.
std::string png_of(const GrayImage& image);
std::string png_of(const RgbImage& image);

// Complete or not at all, see AtomicFile.
void write_png(const std::string& path, const GrayImage& image);
void write_png(const std::string& path, const RgbImage& image);

// Any kind of PNG; what is transparent is seen against white, colours become grey by their
// luminance. Throws InputError where the file is no PNG, damaged, cut short or larger than 2^27
// pixels.
GrayImage read_gray_png(const std::string& path);
RgbImage read_rgb_png(const std::string& path);

// The same from bytes; `name` stands in errors.
GrayImage gray_from_png(std::string_view png, const std::string& name);
RgbImage rgb_from_png(std::string_view png, const std::string& name);

}  // namespace mapbed
