#include "algorithms/grid/map_file.h"

#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "algorithms/grid/map_image.h"
#include "core/config/config_node.h"
#include "core/file/atomic_file.h"
#include "core/image/png.h"
#include "core/image/pnm.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

constexpr std::uint8_t kOccupiedGrey = 0;
constexpr std::uint8_t kFreeGrey = 254;

std::uint8_t grey_of(const Occupancy& cell, const MapFileThresholds& thresholds) {
  if (!cell.known()) return kUnknownGrey;
  if (cell.probability > thresholds.occupied) return kOccupiedGrey;
  return cell.probability < thresholds.free ? kFreeGrey : kUnknownGrey;
}

GrayImage image_of(const OccupancyMap& map, const CellBox& box,
                   const MapFileThresholds& thresholds) {
  GrayImage image(box.width(), box.height());
  auto pixel = image.pixels().begin();
  for (int y = box.max.y; y >= box.min.y; --y) {
    for (int x = box.min.x; x <= box.max.x; ++x) *pixel++ = grey_of(map[{x, y}], thresholds);
  }
  return image;
}

// What the YAML file says.
struct MapDescription {
  std::string image;  // path
  double resolution = 0.0;
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  // [m] lower left corner of the picture
  bool negate = false;                               // white means occupied
  MapFileThresholds thresholds;
};

MapDescription read_description(const std::string& yaml_path) {
  const ConfigNode file = load_config(yaml_path);
  MapDescription map;
  map.image = (fs::path(yaml_path).parent_path() / file.at("image").text()).string();
  map.resolution = file.at("resolution").number(Unit::none, kPositive);
  const ConfigNode& origin = file.at("origin");
  const std::vector<double> pose = origin.numbers();
  if (pose.size() != 3) {
    throw InputError(origin.place(), fmt::format("origin has {} numbers", pose.size()),
                     "it needs x, y and yaw, as in [-10.0, -10.0, 0.0]");
  }
  if (pose[2] != 0.0) {
    throw InputError(origin.place(), fmt::format("the map is turned by {} rad", pose[2]),
                     "only maps with yaw 0 can be read; turn the picture instead");
  }
  map.origin = {pose[0], pose[1]};
  map.negate = file.at("negate").whole_number(between(0, 1)) == 1;
  map.thresholds.occupied = file.at("occupied_thresh").number(Unit::none, kShare);
  map.thresholds.free = file.at("free_thresh").number(Unit::none, kShare);
  if (map.thresholds.free >= map.thresholds.occupied) {
    throw InputError(file.at("free_thresh").place(), "free_thresh is not below occupied_thresh",
                     "the usual values are 0.196 and 0.65");
  }
  const ConfigNode* mode = file.find("mode");
  if (mode != nullptr && mode->text() != "trinary") {
    throw InputError(mode->place(), "maps of mode " + in_quotes(mode->text()) + " cannot be read",
                     "save the map in mode trinary");
  }
  file.check_all_used("a map file");
  return map;
}

// The frame in which the picture's lower left cell is `first`: cell (0, 0) at the map frame's
// origin where the cells' borders allow it.
struct Placement {
  GridFrame frame;
  CellIndex first;
};

Placement place(const MapDescription& map) {
  const Eigen::Vector2d cells = map.origin / map.resolution;
  const Eigen::Vector2d whole(std::round(cells.x()), std::round(cells.y()));
  constexpr double kReach = OccupancyMap::kMaxTiles * OccupancyMap::kTileSide / 2;
  const bool aligned = (cells - whole).cwiseAbs().maxCoeff() < 1e-6;
  if (aligned && whole.cwiseAbs().maxCoeff() < kReach) {
    return {GridFrame{.resolution = map.resolution},
            {static_cast<int>(whole.x()), static_cast<int>(whole.y())}};
  }
  return {GridFrame{.resolution = map.resolution, .origin = map.origin}, {0, 0}};
}

Occupancy occupancy_of(std::uint8_t grey, const MapDescription& map) {
  const double probability = (map.negate ? grey : 255 - grey) / 255.0;
  if (probability > map.thresholds.occupied) return known(1.0);
  return probability < map.thresholds.free ? known(0.0) : Occupancy{};
}

}  // namespace

void write_map(const std::string& stem, const OccupancyMap& map,
               const MapFileThresholds& thresholds) {
  const CellBox box = image_box(map, stem);
  const Eigen::Vector2d corner = map.frame().corner_of(box.min);
  write_pgm(stem + ".pgm", image_of(map, box, thresholds));
  write_file(stem + ".yaml",
             fmt::format("image: {}\nmode: trinary\nresolution: {}\norigin: [{}, {}, 0]\n"
                         "negate: 0\noccupied_thresh: {}\nfree_thresh: {}\n",
                         fs::path(stem + ".pgm").filename().string(), map.resolution(), corner.x(),
                         corner.y(), thresholds.occupied, thresholds.free));
}

OccupancyMap read_map(const std::string& yaml_path) {
  const MapDescription description = read_description(yaml_path);
  const bool is_png = fs::path(description.image).extension() == ".png";
  const GrayImage image = is_png ? read_gray_png(description.image) : read_pgm(description.image);
  const Placement placement = place(description);
  OccupancyMap map(placement.frame);
  OccupancyMap::Writer writer(map);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const Occupancy cell = occupancy_of(image.at(x, image.height() - 1 - y), description);
      if (cell.known()) writer.at({placement.first.x + x, placement.first.y + y}) = cell;
    }
  }
  return map;
}

}  // namespace mapbed
