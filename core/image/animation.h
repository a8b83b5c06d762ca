#pragma once

#include <memory>
#include <ostream>
#include <vector>

#include "core/image/image.h"

namespace mapbed {

// A film on its way into a file, frame by frame.
class Animation {
 public:
  virtual ~Animation() = default;  // without finish(): the file is of no use

  virtual void add(const RgbImage& frame) = 0;  // of the film's size
  virtual void finish() = 0;                    // once
};

struct AnimationShape {
  int width = 0, height = 0;  // [pixels]
  double rate = 20.0;         // frames a second
};

// Both are shown again and again, and have the nearest of the palette's colours, without dithering
// (palette.h): files of areas of one colour are small.

// GIF. Of a frame only the rectangle that changed is written. At most 255 colours, 50 frames a
// second, and 65535 pixels a side.
std::unique_ptr<Animation> gif_animation(std::ostream& out, const AnimationShape& shape,
                                         const std::vector<Rgb>& palette);

// WebP, without any other loss. It is in memory, compressed, until it is finished. At most 256
// colours, and 16383 pixels a side.
std::unique_ptr<Animation> webp_animation(std::ostream& out, const AnimationShape& shape,
                                          const std::vector<Rgb>& palette);

// In the bytes of each of these files: who wrote it.
inline constexpr const char* kAnimationMark = "mapbed film";

}  // namespace mapbed
