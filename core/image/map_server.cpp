#include "core/image/map_server.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "core/check.h"
#include "core/config/config_node.h"
#include "core/config/suggestion.h"
#include "core/config/yaml_scalar.h"
#include "core/file/atomic_file.h"
#include "core/geometry/angle.h"
#include "core/image/pgm.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

constexpr std::uint8_t kOccupiedGrey = 0;
constexpr std::uint8_t kUnknownGrey = 205;
constexpr std::uint8_t kUnknownPercent = 255;  // in mode raw
constexpr std::uint8_t kFreeGrey = 254;

// 0, 1 and all that YAML calls true or false.
bool truth_of(const ConfigNode& node) {
  std::string word = node.text();
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (word == "1" || word == "true" || word == "yes" || word == "on") return true;
  if (word == "0" || word == "false" || word == "no" || word == "off") return false;
  throw InputError(node.place(), in_quotes(node.text()) + " is neither true nor false",
                   "write 'negate: 0', or 1 where white means occupied");
}

Pose2 pose_of(const ConfigNode& origin) {
  const std::vector<double> pose = origin.numbers(Unit::none, between(-1e8, 1e8));
  if (pose.size() != 3) {
    throw InputError(origin.place(), fmt::format("origin has {} numbers", pose.size()),
                     "it needs x, y and yaw, as in [-10.0, -10.0, 0.0]");
  }
  return {pose[0], pose[1], normalized_angle(pose[2])};
}

MapServerThresholds thresholds_of(const ConfigNode& file) {
  MapServerThresholds thresholds;
  const ConfigNode* occupied = file.find("occupied_thresh");
  const ConfigNode* free = file.find("free_thresh");
  if (occupied != nullptr) thresholds.occupied = occupied->number(Unit::none, kFraction);
  if (free != nullptr) thresholds.free = free->number(Unit::none, kFraction);
  if (thresholds.free >= thresholds.occupied) {
    throw InputError((free != nullptr ? free : occupied)->place(),
                     fmt::format("free_thresh {} is not below occupied_thresh {}", thresholds.free,
                                 thresholds.occupied),
                     "the usual values are 0.196 and 0.65");
  }
  return thresholds;
}

// Keys of other programs do no harm, misspelt ones of ours do.
void check_keys(const ConfigNode& file) {
  static const std::vector<std::string> kKeys = {
      "image", "mode", "resolution", "origin", "negate", "occupied_thresh", "free_thresh"};
  for (const std::string& key : file.keys()) {
    const bool known = std::find(kKeys.begin(), kKeys.end(), key) != kKeys.end();
    if (known || nearest(key, kKeys).empty()) continue;
    throw InputError(file.at(key).place(), "unknown key " + in_quotes(key) + " in a map file",
                     suggestion(key, kKeys));
  }
}

// What one pixel says.
class Reading {
 public:
  Reading(const Samples& picture, const MapServerFile& file)
      : picture_(picture),
        file_(file),
        trinary_(file.mode == MapServerMode::trinary),
        count_alpha_(trinary_ && picture.has_alpha()),
        white_((count_alpha_ ? 4 : 3) * picture.white) {}

  float operator()(const std::uint16_t* pixel) const {
    const int bright = brightness_of(pixel);
    if (file_.mode == MapServerMode::raw) return of_percent(std::round(255.0 * bright / white_));
    if (!trinary_ && is_transparent(pixel)) return MapServerMap::kUnknown;
    const double occupied = static_cast<double>(file_.negate ? bright : white_ - bright) / white_;
    const auto& [upper, lower] = file_.thresholds;
    if (occupied > upper) return 1.0F;
    if (occupied < lower) return 0.0F;
    return trinary_ ? MapServerMap::kUnknown
                    : static_cast<float>((occupied - lower) / (upper - lower));
  }

 private:
  // 0 to white_; a grey counts as three equal colours.
  int brightness_of(const std::uint16_t* pixel) const {
    const int colors = picture_.channels < 3 ? 3 * pixel[0] : pixel[0] + pixel[1] + pixel[2];
    return count_alpha_ ? colors + pixel[picture_.channels - 1] : colors;
  }
  bool is_transparent(const std::uint16_t* pixel) const {
    return picture_.has_alpha() && pixel[picture_.channels - 1] < picture_.white;
  }
  static float of_percent(double percent) {
    return percent <= 100.0 ? static_cast<float>(percent / 100.0) : MapServerMap::kUnknown;
  }

  const Samples& picture_;
  const MapServerFile& file_;
  bool trinary_;
  bool count_alpha_;
  int white_;
};

}  // namespace

MapServerFile read_map_server_file(const std::string& yaml_path) {
  const ConfigNode file = load_config(yaml_path);
  MapServerFile map;
  const ConfigNode& image = file.at("image");
  map.image = (fs::path(yaml_path).parent_path() / image.text()).string();
  map.image_place = image.place();
  map.resolution = file.at("resolution").number(Unit::none, between(1e-4, 1000.0));
  map.map_from_image = pose_of(file.at("origin"));
  const ConfigNode* mode = file.find("mode");
  if (mode != nullptr) {
    map.mode = static_cast<MapServerMode>(mode->choice({"trinary", "scale", "raw"}));
  }
  const ConfigNode* negate = file.find("negate");
  map.negate = negate != nullptr && truth_of(*negate);
  if (map.negate && map.mode == MapServerMode::raw) {
    throw InputError(negate->place(),
                     "negate has no one meaning in mode raw: map_server inverts "
                     "the values, Nav2 does not",
                     "write 'negate: 0', and invert the picture if you have to");
  }
  map.thresholds = thresholds_of(file);
  check_keys(file);
  return map;
}

MapServerMap read_map_server(const std::string& yaml_path) {
  const MapServerFile file = read_map_server_file(yaml_path);
  if (!fs::exists(file.image)) {
    throw InputError(file.image_place, "there is no picture " + in_quotes(file.image),
                     "its path counts from the folder of this file");
  }
  return {occupancy_of(read_samples(file.image), file), file.resolution, file.map_from_image,
          file.thresholds};
}

Image<float> occupancy_of(const Samples& picture, const MapServerFile& file) {
  const Reading read(picture, file);
  Image<float> occupancy(picture.width, picture.height);
  const std::uint16_t* pixel = picture.values.data();
  for (float& cell : occupancy.pixels()) {
    cell = read(pixel);
    pixel += picture.channels;
  }
  return occupancy;
}

std::uint8_t map_server_grey(float occupancy, MapServerMode mode,
                             const MapServerThresholds& thresholds) {
  CHECK(mode != MapServerMode::scale);
  if (mode == MapServerMode::raw) {
    return occupancy < 0.0F ? kUnknownPercent
                            : static_cast<std::uint8_t>(std::lround(100.0F * occupancy));
  }
  if (occupancy > thresholds.occupied) return kOccupiedGrey;
  const bool free = occupancy >= 0.0F && occupancy < thresholds.free;
  return free ? kFreeGrey : kUnknownGrey;
}

std::string map_server_yaml(const std::string& image, const MapServerFile& file) {
  CHECK(file.mode != MapServerMode::scale && !file.negate);
  return fmt::format(
      "image: {}\nmode: {}\nresolution: {}\norigin: [{}, {}, {}]\n"
      "negate: 0\noccupied_thresh: {}\nfree_thresh: {}\n",
      yaml_scalar(image), file.mode == MapServerMode::raw ? "raw" : "trinary", file.resolution,
      file.map_from_image.x, file.map_from_image.y, file.map_from_image.theta,
      file.thresholds.occupied, file.thresholds.free);
}

void write_map_server(const std::string& stem, const GrayImage& greys, const MapServerFile& file) {
  const std::string yaml = map_server_yaml(fs::path(stem + ".pgm").filename().string(), file);
  write_pgm(stem + ".pgm", greys);
  write_file(stem + ".yaml", yaml);
}

void write_map_server(const std::string& stem, const MapServerMap& map, MapServerMode mode) {
  GrayImage greys(map.occupancy.width(), map.occupancy.height());
  std::transform(map.occupancy.pixels().begin(), map.occupancy.pixels().end(),
                 greys.pixels().begin(),
                 [&](float occupancy) { return map_server_grey(occupancy, mode, map.thresholds); });
  write_map_server(stem, greys,
                   {.resolution = map.resolution,
                    .map_from_image = map.map_from_image,
                    .mode = mode,
                    .thresholds = map.thresholds});
}

}  // namespace mapbed
