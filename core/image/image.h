#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/check.h"

namespace mapbed {

struct Rgb {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  friend bool operator==(const Rgb&, const Rgb&) = default;
};

inline constexpr Rgb kBlack{0, 0, 0};
inline constexpr Rgb kWhite{255, 255, 255};

// A picture, row by row from the top; pixel (0, 0) is at the top left. sRGB.
template <class Pixel>
class Image {
 public:
  Image() = default;
  Image(int width, int height, Pixel fill = {})
      : width_(width), height_(height), pixels_(count(width, height), fill) {}

  int width() const { return width_; }
  int height() const { return height_; }
  bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }

  Pixel& at(int x, int y) { return pixels_[index(x, y)]; }
  const Pixel& at(int x, int y) const { return pixels_[index(x, y)]; }

  std::vector<Pixel>& pixels() { return pixels_; }
  const std::vector<Pixel>& pixels() const { return pixels_; }

  friend bool operator==(const Image&, const Image&) = default;

 private:
  static std::size_t count(int width, int height) {
    CHECK(width >= 0 && height >= 0);
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  std::size_t index(int x, int y) const {
    CHECK(contains(x, y));
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  int width_ = 0;
  int height_ = 0;
  std::vector<Pixel> pixels_;
};

using GrayImage = Image<std::uint8_t>;  // 0 black, 255 white
using RgbImage = Image<Rgb>;

}  // namespace mapbed
