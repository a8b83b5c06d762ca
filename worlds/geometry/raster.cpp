#include "worlds/geometry/raster.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/check.h"
#include "core/input_error.h"
#include "worlds/geometry/footprint.h"

namespace mapbed {
namespace {

constexpr std::int32_t kNothing = -1;

TrueMap empty_map(const World& world, const RasterOptions& options) {
  CHECK(options.resolution > 0.0);
  const Eigen::AlignedBox3d box = bounds_of(world);
  if (box.isEmpty()) throw InputError("world '" + world.name + "' has nothing to draw a map of");
  TrueMap map;
  map.resolution = options.resolution;
  // Cells on a grid that is the same for all margins and worlds.
  const Eigen::Array2d low = (box.min().head<2>().array() - options.margin) / options.resolution;
  const Eigen::Array2d high = (box.max().head<2>().array() + options.margin) / options.resolution;
  const Eigen::Array2d first = low.floor();
  const Eigen::Array2d count = high.ceil() - first;
  const double cells = count.prod();
  if (cells > options.max_cells) {
    throw InputError(fmt::format(
        "world '{}' is too large for memory: {:.0f} m x {:.0f} m at {} m are {:.2g} cells, at most "
        "{:.2g} fit; take a coarser resolution",
        world.name, box.sizes().x(), box.sizes().y(), options.resolution, cells,
        options.max_cells));
  }
  map.origin = first.matrix() * options.resolution;
  map.width = static_cast<int>(count.x());
  map.height = static_cast<int>(count.y());
  map.cells.assign(static_cast<std::size_t>(cells), TrueCell::unknown);
  map.entities.assign(map.cells.size(), kNothing);
  return map;
}

// Everything is compared with all cells of its box, corner by corner.
void check_cost(const World& world, const std::vector<Footprint>& things,
                const RasterOptions& options) {
  double looks = 0.0;
  for (const Footprint& thing : things) {
    looks += (bounds_of(thing).sizes() / options.resolution).array().ceil().max(1.0).prod() *
             static_cast<double>(std::max<std::size_t>(1, thing.outline.size()));
  }
  if (looks <= options.max_looks) return;
  throw InputError(fmt::format(
      "world '{}' has too many or too large things for a map of cells of {} m; take a coarser "
      "resolution",
      world.name, options.resolution));
}

// Marks every cell into which the footprint reaches.
void draw(TrueMap& map, const Footprint& footprint) {
  const Eigen::AlignedBox2d box = bounds_of(footprint);
  const Eigen::Array2d low = ((box.min() - map.origin) / map.resolution).array().floor();
  const Eigen::Array2d high = ((box.max() - map.origin) / map.resolution).array().floor();
  const int first_x = std::max(0, static_cast<int>(low.x()));
  const int first_y = std::max(0, static_cast<int>(low.y()));
  const int last_x = std::min(map.width - 1, static_cast<int>(high.x()));
  const int last_y = std::min(map.height - 1, static_cast<int>(high.y()));
  // A hair smaller than the cell: a wall that ends at the border does not reach in.
  const double half = map.resolution * (0.5 - 1e-6);
  for (int y = first_y; y <= last_y; ++y) {
    for (int x = first_x; x <= last_x; ++x) {
      const Eigen::Vector2d c = map.origin + map.resolution * Eigen::Vector2d(x + 0.5, y + 0.5);
      if (!covers(footprint, c)) {
        Footprint cell;
        cell.outline = {{c.x() - half, c.y() - half},
                        {c.x() + half, c.y() - half},
                        {c.x() + half, c.y() + half},
                        {c.x() - half, c.y() + half}};
        if (distance_between(cell, footprint) > 0.0) continue;
      }
      map.entities[map.index(x, y)] = footprint.entity;
    }
  }
}

// All open cells that hang together with the world's paths.
void flood(TrueMap& map, const World& world) {
  std::vector<std::uint32_t> front;  // half the size: a map has less than 4e9 cells
  const auto visit = [&](int x, int y) {
    if (x < 0 || y < 0 || x >= map.width || y >= map.height) return;
    const std::size_t i = map.index(x, y);
    if (map.cells[i] == TrueCell::free || map.entities[i] != kNothing) return;
    map.cells[i] = TrueCell::free;
    front.push_back(static_cast<std::uint32_t>(i));
  };
  for (const NamedPath& path : world.paths) {
    for (const WayPoint& point : path.points) {
      const Eigen::Array2d cell = ((point.position - map.origin) / map.resolution).array().floor();
      visit(static_cast<int>(cell.x()), static_cast<int>(cell.y()));
    }
  }
  const auto width = static_cast<std::size_t>(map.width);
  while (!front.empty()) {
    const std::size_t i = front.back();
    front.pop_back();
    const int x = static_cast<int>(i % width);
    const int y = static_cast<int>(i / width);
    visit(x - 1, y);
    visit(x + 1, y);
    visit(x, y - 1);
    visit(x, y + 1);
  }
}

bool has_free_neighbour(const TrueMap& map, int x, int y) {
  for (int v = std::max(0, y - 1); v <= std::min(map.height - 1, y + 1); ++v) {
    for (int u = std::max(0, x - 1); u <= std::min(map.width - 1, x + 1); ++u) {
      if (map.at(u, v) == TrueCell::free) return true;
    }
  }
  return false;
}

}  // namespace

TrueMap raster(const World& world, const RasterOptions& options) {
  TrueMap map = empty_map(world, options);
  constexpr double kThin = 1e-6;  // [m] a cut has no thickness
  const std::vector<Footprint> things =
      footprints(world, options.height - kThin, options.height + kThin);
  check_cost(world, things, options);
  for (const Footprint& thing : things) draw(map, thing);
  if (world.paths.empty()) {
    for (std::size_t i = 0; i < map.cells.size(); ++i) {
      if (map.entities[i] == kNothing) map.cells[i] = TrueCell::free;
    }
  } else {
    flood(map, world);
  }
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const std::size_t i = map.index(x, y);
      if (map.entities[i] == kNothing) continue;
      map.cells[i] = has_free_neighbour(map, x, y) ? TrueCell::occupied : TrueCell::interior;
    }
  }
  return map;
}

}  // namespace mapbed
