#pragma once

#include "algorithms/grid/occupancy_map.h"
#include "core/image/image.h"

namespace mapbed {

inline constexpr Rgb kUnknownColor{205, 214, 224};
inline constexpr Rgb kDynamicColor{230, 120, 0};  // where beams met what moves

// The box of what is known, without the far ends of stray beams: a few that went out of a window
// would shrink the building to a corner. Empty where nothing is known.
CellBox box_of_surroundings(const OccupancyMap& map);

// The cells of a box as a picture, y up, a pixel for so many cells each way: free is white,
// occupied black, unknown grey-blue. Where a pixel holds several cells, thin walls stay visible.
RgbImage image_of_cells(const OccupancyMap& map, const CellBox& box, int cells_per_pixel);

}  // namespace mapbed
