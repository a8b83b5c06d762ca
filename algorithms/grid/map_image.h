#pragma once

#include <cstdint>
#include <string>

#include "algorithms/grid/occupancy_map.h"
#include "core/image/image.h"

namespace mapbed {

// A map as a picture, one pixel a cell, y up: from white (surely free) to black (surely occupied).
// What is unknown has a grey of its own, which no known cell gets.
inline constexpr std::uint8_t kUnknownGrey = 205;

// Of the known cells' bounding box, `image_box`.
GrayImage to_image(const OccupancyMap& map);
GrayImage to_image(const OccupancyMap& map, const CellBox& box);

// The cells that a picture of the map shows. Throws InputError where nothing is known, or where
// the box is too large for a picture; `name` stands in the message.
CellBox image_box(const OccupancyMap& map, const std::string& name = "the map");

// Throws InputError where a box of cells is too large for a picture.
void check_image_size(const CellBox& box, double resolution, const std::string& name = "the map");

}  // namespace mapbed
