#pragma once

#include "core/image/image.h"

namespace mapbed {

enum class ColorMap { gray, blue_to_yellow };

// The colour of a fraction in [0, 1]; fractions outside take the nearest end, NaN the colour of 0.
//   gray            black to white
//   blue_to_yellow  dark blue over grey to light yellow, a straight line in the Oklab space: equal
//                   steps look equally large, lightness grows all the way (it survives a black and
//                   white printer), and it looks nearly the same with red-green blindness.
Rgb color_of(ColorMap map, double fraction);

// Colours for things of different kinds, told apart with every common kind of colour blindness: the
// eight of Okabe and Ito (2008), black first; they repeat after eight.
Rgb categorical_color(int index);  // index >= 0

}  // namespace mapbed
