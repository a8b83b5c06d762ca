#include "core/image/map_server.h"

#include <gtest/gtest.h>

#include "core/file/atomic_file.h"
#include "core/file/text_file.h"
#include "core/image/pgm.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

constexpr float kUnknown = MapServerMap::kUnknown;
using Cells = std::vector<float>;

// One row of pixels.
Samples row_of(int channels, int white, const std::vector<std::uint16_t>& values) {
  return {.width = static_cast<int>(values.size()) / channels,
          .height = 1,
          .channels = channels,
          .white = white,
          .values = values};
}

MapServerFile file_of(MapServerMode mode, bool negate = false) {
  MapServerFile file;
  file.mode = mode;
  file.negate = negate;
  file.thresholds = {.occupied = 0.6, .free = 0.2};
  return file;
}

Cells read(const Samples& picture, const MapServerFile& file) {
  return occupancy_of(picture, file).pixels();
}

TEST(MapServerPixels, AreOccupiedFreeOrUnknownInModeTrinary) {
  // 255 - 101 = 154 is above 0.6 * 255 = 153, 102 is not; 205 and 204 are 50 and 51 from white.
  const Samples greys = row_of(1, 255, {0, 101, 102, 128, 204, 205, 255});
  EXPECT_EQ(read(greys, file_of(MapServerMode::trinary)),
            (Cells{1, 1, kUnknown, kUnknown, kUnknown, 0, 0}));
  EXPECT_EQ(read(greys, file_of(MapServerMode::trinary, true)),
            (Cells{0, kUnknown, kUnknown, kUnknown, 1, 1, 1}));
}

TEST(MapServerPixels, GrowLinearlyBetweenTheThresholdsInModeScale) {
  const Samples percents = row_of(1, 100, {100, 81, 70, 60, 50, 39, 0});
  const Cells scaled = read(percents, file_of(MapServerMode::scale));
  const Cells expected = {0, 0, 0.25F, 0.5F, 0.75F, 1, 1};  // (p - 0.2) / 0.4
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(scaled[i], expected[i], 1e-6) << i;
  const Cells negated = read(percents, file_of(MapServerMode::scale, true));
  EXPECT_EQ(negated.front(), 1.0F);
  EXPECT_NEAR(negated[4], 0.75F, 1e-6);
  EXPECT_EQ(negated.back(), 0.0F);
}

TEST(MapServerPixels, ArePercentInModeRaw) {
  const Samples percents = row_of(1, 255, {0, 1, 50, 100, 101, 255});
  EXPECT_EQ(read(percents, file_of(MapServerMode::raw)),
            (Cells{0, 0.01F, 0.5F, 1, kUnknown, kUnknown}));
  const Samples wide = row_of(1, 65535, {257 * 7, 257 * 100, 65535});
  EXPECT_EQ(read(wide, file_of(MapServerMode::raw)), (Cells{0.07F, 1, kUnknown}))
      << "of 255, however many bits there are";
}

TEST(MapServerPixels, OfColorsCountByTheirMean) {
  const Samples colors = row_of(3, 255, {255, 0, 0, 255, 255, 0, 7, 9, 5});
  EXPECT_EQ(read(colors, file_of(MapServerMode::trinary)), (Cells{1, kUnknown, 1}));  // 2/3, 1/3
  EXPECT_EQ(read(colors, file_of(MapServerMode::raw)), (Cells{0.85F, kUnknown, 0.07F}));
}

TEST(MapServerPixels, ThatAreTransparentAreUnknownInModeScaleAndAShadeInTrinary) {
  const Samples alpha = row_of(2, 255, {0, 255, 0, 254, 0, 0, 255, 0});
  EXPECT_EQ(read(alpha, file_of(MapServerMode::scale)), (Cells{1, kUnknown, kUnknown, kUnknown}));
  // (3 * 0 + 255) / 4 of 255 is bright by a quarter, (3 * 255 + 0) / 4 by three.
  EXPECT_EQ(read(alpha, file_of(MapServerMode::trinary)), (Cells{1, 1, 1, kUnknown}));
  EXPECT_EQ(read(row_of(4, 255, {100, 100, 100, 0}), file_of(MapServerMode::raw)), (Cells{1}));
}

class MapServer : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.file(name); }

  // A file of a 2 x 1 picture, with one line changed.
  std::string file(const std::string& from = "", const std::string& to = "") const {
    write_file(path("Plan.PGM"), "P2 2 1 9 0 9");
    std::string yaml =
        "image: Plan.PGM\nresolution: 0.05\norigin: [-1.0, 2.0, 0.0]\nnegate: 0\n"
        "occupied_thresh: 0.65\nfree_thresh: 0.196\n";
    yaml.replace(yaml.find(from), from.size(), to);
    write_file(path("plan.yaml"), yaml);
    return path("plan.yaml");
  }

  Cells cells(const std::string& from, const std::string& to) const {
    return read_map_server(file(from, to)).occupancy.pixels();
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(MapServer, ReadsBackWhatItWrote) {
  MapServerMap map{.occupancy = Image<float>(3, 2, kUnknown),
                   .resolution = 0.1,
                   .map_from_image = {-3.7, 1e-3, 0.7},
                   .thresholds = {.occupied = 0.9, .free = 0.1}};
  map.occupancy.at(0, 0) = 1.0F;
  map.occupancy.at(2, 1) = 0.0F;
  write_map_server(path("a: map"), map);
  const MapServerMap again = read_map_server(path("a: map.yaml"));
  EXPECT_EQ(again.occupancy, map.occupancy);
  EXPECT_EQ(again.resolution, map.resolution);
  EXPECT_EQ(again.map_from_image, map.map_from_image);
  EXPECT_EQ(again.thresholds.occupied, map.thresholds.occupied);
  EXPECT_EQ(again.thresholds.free, map.thresholds.free);
}

TEST_F(MapServer, WritesWhatMapServersRead) {
  MapServerMap map{
      .occupancy = Image<float>(4, 1), .resolution = 0.5, .map_from_image = {-1, 2, 0}};
  map.occupancy.pixels() = {0.0F, 0.5F, 1.0F, kUnknown};
  write_map_server(path("map"), map);
  EXPECT_EQ(read_text_file(path("map.yaml")),
            "image: map.pgm\nmode: trinary\nresolution: 0.5\norigin: [-1, 2, 0]\nnegate: 0\n"
            "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  EXPECT_EQ(read_samples(path("map.pgm")).values, (std::vector<std::uint16_t>{254, 205, 0, 205}));
}

TEST_F(MapServer, ReadsFilesOfOthers) {
  EXPECT_EQ(cells("", ""), (Cells{1, 0}));
  for (const char* yes : {"1", "true", "True", "yes"}) {
    EXPECT_EQ(cells("negate: 0", std::string("negate: ") + yes), (Cells{0, 1})) << yes;
  }
  EXPECT_EQ(cells("negate: 0", "negate: false"), (Cells{1, 0}));
  EXPECT_EQ(cells("negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n", ""), (Cells{1, 0}));
  EXPECT_EQ(cells("negate: 0", "mode: raw\nnegate: 0"), (Cells{0, kUnknown}));
  EXPECT_EQ(cells("negate: 0", "cost_of_lethargy: 7\nnegate: 0"), (Cells{1, 0}))
      << "keys of other programs do no harm";
  EXPECT_NEAR(read_map_server(file("0.0]", "-4.0]")).map_from_image.theta, 2.28318530718, 1e-9);
}

TEST_F(MapServer, SaysWhatIsWrongAndWhere) {
  const auto expect_error = [this](const std::string& from, const std::string& to,
                                   const std::string& message) {
    EXPECT_INPUT_ERROR(read_map_server(file(from, to)), message);
  };
  EXPECT_INPUT_ERROR(read_map_server(path("missing.yaml")), "missing.yaml");
  expect_error("Plan.PGM", "gone.pgm", "plan.yaml:1: there is no picture");
  expect_error("Plan.PGM", "plan.yaml", "plan.yaml: is neither a PNG nor a PGM picture; convert");
  expect_error("0.05", "-0.05", "plan.yaml:2");
  expect_error("0.05", "nan", "plan.yaml:2");
  expect_error(", 0.0]", "]", "plan.yaml:3: origin has 2 numbers; it needs x, y and yaw");
  expect_error("0.65", "0.1", "plan.yaml:6: free_thresh 0.196 is not below occupied_thresh 0.1");
  expect_error("0.65", "65", "plan.yaml:5");
  expect_error("negate: 0", "negate: maybe", "plan.yaml:4: 'maybe' is neither true nor false");
  expect_error("negate: 0", "mode: rwa", "did you mean 'raw'?");
  expect_error("negate: 0", "mode: raw\nnegate: 1", "plan.yaml:5: negate has no one meaning");
  expect_error("negate: 0", "negat: 0", "unknown key 'negat' in a map file; did you mean 'negate'");
}

}  // namespace
}  // namespace mapbed
