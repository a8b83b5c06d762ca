#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace mapbed {

// The pixels of a picture as its file holds them: not rounded, no gamma, colours not mixed. What
// pixels are read from when they are data and not something to look at.
struct Samples {
  int width = 0;
  int height = 0;
  int channels = 1;  // 1 gray, 2 gray and alpha, 3 red, green and blue, 4 with alpha
  int white = 255;   // the value of white, and of what is opaque: up to 65535
  std::vector<std::uint16_t> values;  // row by row from the top, the channels of a pixel together

  friend bool operator==(const Samples&, const Samples&) = default;
  bool has_alpha() const { return channels % 2 == 0; }
  const std::uint16_t* pixel(int x, int y) const {
    return &values[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(x)) *
                   static_cast<std::size_t>(channels)];
  }
};

// Any PNG (palettes become colours) and PGM (P2 and P5, up to 16 bits), told apart by their first
// bytes, whatever the file is called. Throws InputError where it is neither, damaged, cut short or
// larger than 2^26 pixels.
Samples read_samples(const std::string& path);

// The same from bytes; `name` stands in errors.
Samples samples_from(std::string_view picture, const std::string& name);

}  // namespace mapbed
