#include "algorithms/grid/map_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "algorithms/grid/map_image.h"
#include "core/file/atomic_file.h"
#include "core/image/pgm.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

// The frame in which the cell with its lower left corner at `corner` is `first`: cell (0, 0) at the
// map frame's origin where the cells' borders allow it.
struct Placement {
  GridFrame frame;
  CellIndex first;
};

constexpr double kMostCells = 1 << 28;  // of the upright box around a turned map

Placement place(const Eigen::Vector2d& corner, double resolution) {
  const Eigen::Vector2d cells = corner / resolution;
  const Eigen::Vector2d whole(std::round(cells.x()), std::round(cells.y()));
  constexpr double kReach = OccupancyMap::kMaxTiles * OccupancyMap::kTileSide / 2;
  const bool aligned = (cells - whole).cwiseAbs().maxCoeff() < 1e-6;
  if (aligned && whole.cwiseAbs().maxCoeff() < kReach) {
    return {GridFrame{.resolution = resolution},
            {static_cast<int>(whole.x()), static_cast<int>(whole.y())}};
  }
  return {GridFrame{.resolution = resolution, .origin = corner}, {0, 0}};
}

void check_sides(const MapServerMap& map) {
  constexpr int kMost = (OccupancyMap::kMaxTiles / 2) * OccupancyMap::kTileSide;
  if (std::max(map.occupancy.width(), map.occupancy.height()) <= kMost) return;
  throw InputError("a map of " + std::to_string(map.occupancy.width()) + " x " +
                   std::to_string(map.occupancy.height()) + " cells is too long; at most " +
                   std::to_string(kMost) + " fit; make its picture coarser");
}

// The upright box around the picture, in the map frame.
Eigen::AlignedBox2d bounds_of(const MapServerMap& map) {
  const double width = map.occupancy.width() * map.resolution;
  const double height = map.occupancy.height() * map.resolution;
  Eigen::AlignedBox2d box;
  for (const double x : {0.0, width}) {
    for (const double y : {0.0, height}) box.extend(map.map_from_image * Eigen::Vector2d(x, y));
  }
  return box;
}

OccupancyMap turned_map_of(const MapServerMap& map) {
  const Eigen::AlignedBox2d bounds = bounds_of(map);
  const Placement placement = place(bounds.min(), map.resolution);
  const Pose2 image_from_map = inverse(map.map_from_image);
  const Eigen::Array2d sides = (bounds.sizes() / map.resolution).array();
  if (!(sides.prod() <= kMostCells)) {
    throw InputError(
        fmt::format("a map of {} x {} cells is too long to be turned; make its picture "
                    "coarser, or write it with an origin of yaw 0",
                    map.occupancy.width(), map.occupancy.height()));
  }
  const Eigen::Array2i cells = (sides - 1e-6).ceil().cast<int>();
  OccupancyMap result(placement.frame);
  OccupancyMap::Writer writer(result);
  for (int y = placement.first.y; y < placement.first.y + cells.y(); ++y) {
    for (int x = placement.first.x; x < placement.first.x + cells.x(); ++x) {
      const Eigen::Vector2d in_image = image_from_map * result.center_of({x, y});
      const Eigen::Array2d pixel = (in_image / map.resolution).array().floor();
      const int column = static_cast<int>(pixel.x());
      const int row = map.occupancy.height() - 1 - static_cast<int>(pixel.y());
      if (!map.occupancy.contains(column, row)) continue;
      const float occupancy = map.occupancy.at(column, row);
      if (occupancy >= 0.0F) writer.at({x, y}) = {occupancy};
    }
  }
  return result;
}

// Greys are probabilities, in full steps; the grey of the unknown is as to_image() draws it.
Image<float> occupancy_of_picture(const std::string& path) {
  MapServerFile greys;
  greys.mode = MapServerMode::scale;
  greys.thresholds = {.occupied = 1.0, .free = 0.0};
  Image<float> occupancy = occupancy_of(read_samples(path), greys);
  constexpr auto kGreyOfUnknown = static_cast<float>((255 - kUnknownGrey) / 255.0);
  std::replace(occupancy.pixels().begin(), occupancy.pixels().end(), kGreyOfUnknown,
               MapServerMap::kUnknown);
  return occupancy;
}

GrayImage greys_of(const OccupancyMap& map, const CellBox& box, MapServerMode mode) {
  GrayImage greys(box.width(), box.height());
  auto pixel = greys.pixels().begin();
  for (int y = box.max.y; y >= box.min.y; --y) {
    for (int x = box.min.x; x <= box.max.x; ++x) {
      *pixel++ = map_server_grey(map[{x, y}].probability, mode);
    }
  }
  return greys;
}

std::string yaml_of(const OccupancyMap& map, const CellBox& box, const std::string& image,
                    MapServerMode mode) {
  const Eigen::Vector2d corner = map.frame().corner_of(box.min);
  return map_server_yaml(image, {.resolution = map.resolution(),
                                 .map_from_image = {corner.x(), corner.y(), 0.0},
                                 .mode = mode});
}

bool is_yaml(const fs::path& path) {
  return path.extension() == ".yaml" || path.extension() == ".yml";
}

}  // namespace

OccupancyMap occupancy_map_of(const MapServerMap& map) {
  check_sides(map);
  if (map.map_from_image.theta != 0.0) return turned_map_of(map);
  const Placement placement = place(map.map_from_image.position(), map.resolution);
  OccupancyMap result(placement.frame);
  OccupancyMap::Writer writer(result);
  for (int y = 0; y < map.occupancy.height(); ++y) {
    for (int x = 0; x < map.occupancy.width(); ++x) {
      const float occupancy = map.occupancy.at(x, map.occupancy.height() - 1 - y);
      if (occupancy >= 0.0F)
        writer.at({placement.first.x + x, placement.first.y + y}) = {occupancy};
    }
  }
  return result;
}

MapText map_text(const OccupancyMap& map, const std::string& image, MapServerMode mode) {
  const CellBox box = image_box(map, image);
  return {pgm_of(greys_of(map, box, mode)), yaml_of(map, box, image, mode)};
}

void write_map(const std::string& stem, const OccupancyMap& map, MapServerMode mode) {
  const std::string picture = stem + ".pgm", image = fs::path(picture).filename().string();
  const CellBox box = image_box(map, image);
  write_pgm(picture, greys_of(map, box, mode));  // without its text in memory
  write_file(stem + ".yaml", yaml_of(map, box, image, mode));
}

OccupancyMap read_map(const std::string& path, std::optional<double> resolution) {
  if (is_yaml(path)) return occupancy_map_of(read_map_server(path));
  MapServerMap map;
  map.occupancy = occupancy_of_picture(path);
  if (resolution) {
    map.resolution = *resolution;
    return occupancy_map_of(map);
  }
  const std::string beside = fs::path(path).replace_extension(".yaml").string();
  if (!fs::exists(beside)) {
    throw InputError({path}, "does not say how large its cells are",
                     "give --resolution, or put " + in_quotes(beside) + " beside it");
  }
  const MapServerFile file = read_map_server_file(beside);
  const bool names_it =
      fs::path(file.image).lexically_normal() == fs::path(path).lexically_normal();
  if (names_it) return occupancy_map_of(read_map_server(beside));
  map.resolution = file.resolution;
  map.map_from_image = file.map_from_image;
  return occupancy_map_of(map);
}

}  // namespace mapbed
