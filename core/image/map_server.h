#pragma once

#include <cstdint>
#include <string>

#include "core/geometry/pose2.h"
#include "core/image/image.h"
#include "core/image/samples.h"
#include "core/input_error.h"

namespace mapbed {

// Maps in the format of ROS' map_server and Nav2: a picture, and a YAML file that says where it
// lies and what its pixels mean. The occupancy of a pixel is p = (white - value) / white, of
// colours by their plain mean; `negate` makes white occupied. Then, as these programs do:
//   trinary  occupied above occupied_thresh, free below free_thresh, else unknown. An alpha channel
//            counts as one more colour.
//   scale    the same, but p between the thresholds grows linearly from 0 to 1, and what is not
//            opaque is unknown.
//   raw      the value itself, of 255, is the probability in percent; above 100: unknown.
enum class MapServerMode { trinary, scale, raw };

struct MapServerThresholds {
  double occupied = 0.65;
  double free = 0.196;  // the grey of unknown cells, 205, is just above: 50/255
};

// What the YAML file says.
struct MapServerFile {
  std::string image = {};    // path
  double resolution = 0.05;  // [m] side of a pixel
  Pose2 map_from_image;      // lower left corner of the picture, x along its lower edge, y up
  MapServerMode mode = MapServerMode::trinary;
  bool negate = false;
  MapServerThresholds thresholds = {};
  SourceLocation image_place = {};
};

struct MapServerMap {
  static constexpr float kUnknown = -1.0F;

  Image<float> occupancy;  // probability, or kUnknown; row 0 is the upper edge, as in the picture
  double resolution = 0.05;
  Pose2 map_from_image;
  MapServerThresholds thresholds;
};

// `negate`, `mode` and the thresholds may be missing; keys of other programs are passed over.
// Throws InputError, also for `negate` together with `raw`, where map_server and Nav2 disagree.
MapServerFile read_map_server_file(const std::string& yaml_path);

// The map that a YAML file describes. Throws InputError where a file is missing or damaged.
MapServerMap read_map_server(const std::string& yaml_path);

// What a picture says under the mode, the sense and the thresholds of a file.
Image<float> occupancy_of(const Samples& picture, const MapServerFile& file);

// The pixel that stands for a probability, or for kUnknown, in mode trinary or raw.
std::uint8_t map_server_grey(float occupancy, MapServerMode mode,
                             const MapServerThresholds& thresholds = {});

// What NAME.yaml says beside a picture of greys that are made so, by the name of its file; the
// image in `file` is not looked at. Mode trinary or raw.
std::string map_server_yaml(const std::string& image, const MapServerFile& file);

// Writes `stem`.pgm, whose pixels are made so, and `stem`.yaml, each complete or not at all; the
// path of the image in `file` is not looked at. Throws InputError where they cannot be written.
void write_map_server(const std::string& stem, const GrayImage& greys, const MapServerFile& file);

// The same in mode trinary or raw, which keeps probabilities in percent.
void write_map_server(const std::string& stem, const MapServerMap& map,
                      MapServerMode mode = MapServerMode::trinary);

}  // namespace mapbed
