#pragma once

#include <cstdint>
#include <vector>

#include "core/image/image.h"

namespace mapbed {

// At most 256 colours, and of every other one the nearest of them. Without dithering, so that areas
// of one colour stay so.
class Palette {
 public:
  explicit Palette(std::vector<Rgb> colors);

  const std::vector<Rgb>& colors() const { return colors_; }
  // Into colors(). One of these gives itself, or another one that differs in its last bits alone.
  std::uint8_t index_of(const Rgb& color) const { return index_[bin_of(color)]; }
  const Rgb& nearest(const Rgb& color) const { return colors_[index_of(color)]; }

 private:
  static constexpr int kBits = 6;  // of a channel that tell colours apart
  static std::size_t bin_of(const Rgb& color) {
    constexpr int rest = 8 - kBits;
    return (static_cast<std::size_t>(color.red >> rest) << 2 * kBits) |
           (static_cast<std::size_t>(color.green >> rest) << kBits) |
           static_cast<std::size_t>(color.blue >> rest);
  }

  std::vector<Rgb> colors_;
  std::vector<std::uint8_t> index_;  // by bin
};

}  // namespace mapbed
