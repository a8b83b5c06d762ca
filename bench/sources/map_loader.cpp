#include "bench/sources/map_loader.h"

#include <filesystem>

#include "algorithms/grid/map_file.h"
#include "algorithms/grid/map_image.h"
#include "core/config/config_node.h"
#include "core/image/png.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

// Where the lower left corner of a map server's picture lies.
GridFrame frame_from(const std::string& yaml_path) {
  const ConfigNode file = load_config(yaml_path);
  const std::vector<double> origin = file.at("origin").numbers();
  if (origin.size() != 3) {
    throw InputError(file.at("origin").place(), "an origin has three numbers", "write [x, y, 0]");
  }
  return {.resolution = file.at("resolution").number(Unit::none, kPositive),
          .origin = {origin[0], origin[1]}};
}

OccupancyMap map_of_picture(const GrayImage& image, const GridFrame& frame) {
  OccupancyMap map(frame);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const std::uint8_t grey = image.at(x, image.height() - 1 - y);
      if (grey != kUnknownGrey) map.at({x, y}) = known(1.0 - grey / 255.0);
    }
  }
  return map;
}

}  // namespace

OccupancyMap load_map(const std::string& path, std::optional<double> resolution) {
  const fs::path file(path);
  if (file.extension() == ".yaml" || file.extension() == ".yml") return read_map(path);
  if (file.extension() != ".png") {
    throw InputError({path}, "is no map", "give the .yaml of a map server's map or a .png");
  }
  const GrayImage image = read_gray_png(path);
  if (resolution) return map_of_picture(image, {.resolution = *resolution});
  const std::string beside = fs::path(file).replace_extension(".yaml").string();
  if (!fs::exists(beside)) {
    throw InputError({path}, "does not say how large its cells are",
                     "add --resolution, or put '" + beside + "' beside it");
  }
  return map_of_picture(image, frame_from(beside));
}

}  // namespace mapbed
