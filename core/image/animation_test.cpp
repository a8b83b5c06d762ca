// Films as another program reads them: Python's PIL.

#include "core/image/animation.h"

#include <cstdlib>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "core/file/text_file.h"
#include "core/testing/temporary_folder.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;
using ::testing::Lt;

constexpr Rgb kRed{200, 30, 10};
constexpr Rgb kSea{20, 90, 160};

bool has_pil() {
  return std::system("/usr/bin/python3 -c 'import PIL.Image' >/dev/null 2>&1") == 0;
}

// A square of 2 x 2 pixels at x in front of a plain ground.
RgbImage square_at(int x) {
  RgbImage image(12, 6, kWhite);
  for (const int dx : {0, 1}) {
    for (const int dy : {0, 1}) image.at(x + dx, 2 + dy) = dx == 0 ? kRed : kSea;
  }
  return image;
}

class Films : public ::testing::Test {
 protected:
  std::string file(const std::string& name) const { return folder_.file(name); }

  // Size, number of frames, milliseconds of all of them and, of each, the pixels at (1, 2) to (7,
  // 2) by 2.
  std::string read_by_pil(const std::string& name) const {
    std::ofstream(file("read.py")) << R"(
import sys
from PIL import Image, ImageSequence
film = Image.open(sys.argv[1])
frames, milliseconds = [], 0
for frame in ImageSequence.Iterator(film):
    milliseconds += film.info["duration"] if film.format == "GIF" else 0
    pixels = frame.convert("RGB")
    frames.append([pixels.getpixel((x, 2)) for x in (1, 3, 5, 7)])
print(film.format, film.size, len(frames), milliseconds, film.info.get("loop"))
for pixels in frames: print(pixels)
)";
    const std::string command = fmt::format("/usr/bin/python3 '{}' '{}' >'{}' 2>&1",
                                            file("read.py"), file(name), file("said"));
    EXPECT_EQ(std::system(command.c_str()), 0);
    return read_text_file(file("said"));
  }

  TemporaryFolder folder_;
};

constexpr AnimationShape kShape{.width = 12, .height = 6, .rate = 8.0};

constexpr const char* kPixels =
    "[(200, 30, 10), (255, 255, 255), (255, 255, 255), (255, 255, 255)]\n"
    "[(255, 255, 255), (200, 30, 10), (255, 255, 255), (255, 255, 255)]\n"
    "[(255, 255, 255), (255, 255, 255), (200, 30, 10), (255, 255, 255)]\n";

TEST_F(Films, AGifHasTheColorsOfThePaletteAndTheFilmsLength) {
  if (!has_pil()) GTEST_SKIP() << "python3-pil is not installed";
  std::ofstream out(file("a.gif"), std::ios::binary);
  const auto film = gif_animation(out, kShape, {kWhite, kBlack, kRed, kSea});
  for (const int x : {1, 3, 3, 5}) film->add(square_at(x));  // the second one twice as long
  film->finish();
  out.close();
  // Eight frames a second are 12.5 hundredths each, and four of them 50.
  EXPECT_EQ(read_by_pil("a.gif"), fmt::format("GIF (12, 6) 3 500 0\n{}", kPixels));
}

TEST_F(Films, AGifOfMoreColorsTakesTheNearest) {
  if (!has_pil()) GTEST_SKIP() << "python3-pil is not installed";
  std::ofstream out(file("a.gif"), std::ios::binary);
  const auto film = gif_animation(out, kShape, {kWhite, kBlack, {190, 40, 20}});
  film->add(square_at(1));
  film->finish();
  out.close();
  EXPECT_THAT(read_by_pil("a.gif"), HasSubstr("[(190, 40, 20), (255, 255, 255)"));
}

TEST_F(Films, AWebpHasThePixelsThemselves) {
  if (!has_pil()) GTEST_SKIP() << "python3-pil is not installed";
  std::ofstream out(file("a.webp"), std::ios::binary);
  const auto film = webp_animation(out, kShape, {kWhite, kRed, kSea});
  for (const int x : {1, 3, 3, 5}) film->add(square_at(x));
  film->finish();
  out.close();
  EXPECT_EQ(read_by_pil("a.webp"), fmt::format("WEBP (12, 6) 3 0 0\n{}", kPixels));
}

TEST_F(Films, OnlyTheRectangleThatChangedIsWritten) {
  std::ostringstream still, moving;
  const AnimationShape shape{.width = 400, .height = 300, .rate = 10.0};
  RgbImage noise(400, 300);
  std::uint32_t state = 1;
  for (Rgb& pixel : noise.pixels()) {
    state = state * 1664525U + 1013904223U;
    pixel = (state >> 31) != 0U ? kWhite : kBlack;
  }
  for (std::ostringstream* out : {&still, &moving}) {
    const auto film = gif_animation(*out, shape, {kWhite, kBlack, kRed});
    film->add(noise);
    if (out == &moving) {
      noise.at(200, 100) = noise.at(201, 101) = kRed;
      film->add(noise);
    }
    film->finish();
  }
  // A frame of 2 x 2 pixels takes some 30 bytes.
  EXPECT_THAT(moving.str().size() - still.str().size(), Lt(60u));
}

TEST_F(Films, SayWhoWroteThem) {
  for (const bool is_gif : {true, false}) {
    std::ostringstream out;
    const auto film = (is_gif ? gif_animation : webp_animation)(out, kShape, {kWhite, kRed, kSea});
    film->add(square_at(1));
    film->finish();
    EXPECT_THAT(out.str(), HasSubstr(kAnimationMark)) << is_gif;
  }
}

}  // namespace
}  // namespace mapbed
