#include "algorithms/grid/map_image.h"

#include <cmath>

#include <fmt/format.h>

#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr std::int64_t kMaxPixels = std::int64_t{1} << 26;  // what the readers of pictures take

std::uint8_t grey_of(const Occupancy& cell) {
  if (!cell.known()) return kUnknownGrey;
  const auto grey = static_cast<std::uint8_t>(std::lround(255.0F * (1.0F - cell.probability)));
  return grey == kUnknownGrey ? std::uint8_t{kUnknownGrey + 1} : grey;
}

}  // namespace

void check_image_size(const CellBox& box, double resolution, const std::string& name) {
  const std::int64_t pixels = std::int64_t{box.width()} * box.height();
  if (pixels > kMaxPixels) {
    throw InputError(fmt::format(
        "{} is {} x {} cells of {} m, too large for a picture of at most {} pixels; choose larger "
        "cells, {:.2g} m or more",
        name, box.width(), box.height(), resolution, kMaxPixels,
        resolution * std::sqrt(static_cast<double>(pixels) / kMaxPixels) * 1.01));
  }
}

CellBox image_box(const OccupancyMap& map, const std::string& name) {
  const CellBox box = known_box(map);
  if (box.empty()) {
    throw InputError(name +
                     " has no known cell; no scan with a usable beam went into it, or all were cut "
                     "by the usable range");
  }
  check_image_size(box, map.resolution(), name);
  return box;
}

GrayImage to_image(const OccupancyMap& map, const CellBox& box) {
  GrayImage image(box.width(), box.height());
  auto pixel = image.pixels().begin();
  for (int y = box.max.y; y >= box.min.y; --y) {
    for (int x = box.min.x; x <= box.max.x; ++x) *pixel++ = grey_of(map[{x, y}]);
  }
  return image;
}

GrayImage to_image(const OccupancyMap& map) {
  return to_image(map, image_box(map));
}

}  // namespace mapbed
