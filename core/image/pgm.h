#pragma once

#include <string>
#include <string_view>

#include "core/image/image.h"
#include "core/image/samples.h"

namespace mapbed {

// PGM, the simplest format of grey pictures, as map servers read it. Reading: core/image/samples.h.

std::string pgm_of(const GrayImage& image);  // P5

// Complete or not at all, see AtomicFile.
void write_pgm(const std::string& path, const GrayImage& image);

// Binary or plain text (P5 and P2), up to 16 bits, comments allowed. Throws InputError where the
// bytes are of another kind, damaged, cut short or more than 2^26 pixels; `name` stands in errors.
Samples samples_from_pgm(std::string_view pgm, const std::string& name);

}  // namespace mapbed
