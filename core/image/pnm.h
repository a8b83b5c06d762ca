#pragma once

#include <string>
#include <string_view>

#include "core/image/image.h"

namespace mapbed {

// The simplest picture formats: PGM (grey, as map servers read it) and PPM (colour).

std::string pgm_of(const GrayImage& image);  // P5
std::string ppm_of(const RgbImage& image);   // P6

// Complete or not at all, see AtomicFile.
void write_pgm(const std::string& path, const GrayImage& image);
void write_ppm(const std::string& path, const RgbImage& image);

// Binary or plain text (P2, P5 and P3, P6), up to 8 bits a channel, comments allowed. Throws
// InputError where the file is of another kind, damaged, cut short or larger than 2^27 pixels.
GrayImage read_pgm(const std::string& path);
RgbImage read_ppm(const std::string& path);

// The same from bytes; `name` stands in errors.
GrayImage gray_from_pgm(std::string_view pgm, const std::string& name);
RgbImage rgb_from_ppm(std::string_view ppm, const std::string& name);

}  // namespace mapbed
