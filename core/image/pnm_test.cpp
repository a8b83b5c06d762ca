#include "core/image/pnm.h"

#include <gtest/gtest.h>

#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

GrayImage small_gray() {
  GrayImage image(3, 2);
  image.pixels() = {0, 10, 35, 254, 255, 205};  // 10 and 35 look like a line end and a comment
  return image;
}

TEST(Pnm, ReadsBackWhatWasWritten) {
  const TemporaryFolder folder;
  write_pgm(folder.file("a.pgm"), small_gray());
  EXPECT_EQ(read_pgm(folder.file("a.pgm")), small_gray());

  RgbImage color(2, 1);
  color.pixels() = {{1, 2, 3}, {255, 0, 35}};
  write_ppm(folder.file("a.ppm"), color);
  EXPECT_EQ(read_ppm(folder.file("a.ppm")), color);
}

TEST(Pnm, HasTheHeaderThatMapServersRead) {
  EXPECT_EQ(pgm_of(GrayImage(2, 1, 'x')), "P5\n2 1\n255\nxx");
}

TEST(Pnm, ReadsTextCommentsAndOtherRanges) {
  const GrayImage image = gray_from_pgm("P2 # by hand\n# two pixels\n2 1 15\n0 15\n", "x.pgm");
  EXPECT_EQ(image.pixels(), (std::vector<std::uint8_t>{0, 255}));
  EXPECT_EQ(rgb_from_ppm("P3 1 1 255 1 2 3", "x.ppm").at(0, 0), (Rgb{1, 2, 3}));
}

TEST(Pnm, EveryCutIsNoticed) {
  const std::string pgm = pgm_of(small_gray());
  for (std::size_t size = 0; size < pgm.size(); ++size) {
    EXPECT_INPUT_ERROR(gray_from_pgm(pgm.substr(0, size), "x.pgm"), "x.pgm: ");
  }
}

TEST(Pnm, RefusesWhatIsNoPicture) {
  EXPECT_INPUT_ERROR(gray_from_pgm("P6\n1 1\n255\nxxx", "x.pgm"), "is no PGM picture");
  EXPECT_INPUT_ERROR(gray_from_pgm("P5\n-1 1\n255\nx", "x.pgm"), "the width is missing or not");
  EXPECT_INPUT_ERROR(gray_from_pgm("P5\n1 1\n65535\nxx", "x.pgm"), "not between 1 and 255");
  EXPECT_INPUT_ERROR(gray_from_pgm("P5\n1000000 1000000\n255\nx", "x.pgm"), "it was cut short");
  EXPECT_INPUT_ERROR(gray_from_pgm("P5\n1 1\n9\nx", "x.pgm"), "above the largest value");
  EXPECT_INPUT_ERROR(gray_from_pgm("P2\n1 1\n255\nx ", "x.pgm"), "a pixel is missing");
}

}  // namespace
}  // namespace mapbed
