#pragma once

#include <array>

#include "core/image/image.h"

namespace mapbed {

// Colours of those who are followed, by their numbers, told apart with every common kind of colour
// blindness ("muted" of Paul Tol, 2021); as in the pages' replays. They repeat: the number tells
// more.
inline constexpr std::array<Rgb, 6> kTrackColors{
    {{136, 34, 85}, {51, 34, 136}, {17, 119, 51}, {170, 68, 153}, {68, 170, 153}, {153, 153, 51}}};

inline Rgb track_color(int id) {
  const auto size = static_cast<int>(kTrackColors.size());
  return kTrackColors[static_cast<std::size_t>((id % size + size) % size)];
}

}  // namespace mapbed
