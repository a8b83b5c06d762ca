#pragma once

#include "core/image/image.h"

namespace mapbed {

// Of a picture of zeros and ones: 1 where a one lies within `reach` pixels in x and y.
GrayImage dilated(const GrayImage& marks, int reach);

}  // namespace mapbed
