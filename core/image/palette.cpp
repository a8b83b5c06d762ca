#include "core/image/palette.h"

#include <limits>
#include <utility>

#include "core/check.h"

namespace mapbed {
namespace {

int squared(int value) {
  return value * value;
}

std::uint8_t nearest_index(const std::vector<Rgb>& colors, const Rgb& color) {
  std::size_t found = 0;
  int least = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const Rgb& other = colors[i];  // the eye sees green best, blue least
    const int distance = 3 * squared(other.red - color.red) +
                         6 * squared(other.green - color.green) + squared(other.blue - color.blue);
    if (distance >= least) continue;
    least = distance;
    found = i;
  }
  return static_cast<std::uint8_t>(found);
}

}  // namespace

Palette::Palette(std::vector<Rgb> colors)
    : colors_(std::move(colors)), index_(std::size_t{1} << 3 * kBits) {
  CHECK(!colors_.empty() && colors_.size() <= 256);
  constexpr int side = 1 << kBits;
  constexpr int step = 256 / side;
  const auto middle = [](int bin) { return static_cast<std::uint8_t>(bin * step + step / 2); };
  for (int red = 0; red < side; ++red) {
    for (int green = 0; green < side; ++green) {
      for (int blue = 0; blue < side; ++blue) {
        const Rgb color{middle(red), middle(green), middle(blue)};
        index_[bin_of(color)] = nearest_index(colors_, color);
      }
    }
  }
  for (std::size_t i = colors_.size(); i-- > 0;) {
    index_[bin_of(colors_[i])] = static_cast<std::uint8_t>(i);
  }
}

}  // namespace mapbed
