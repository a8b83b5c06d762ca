#include "core/image/pgm.h"

#include <gtest/gtest.h>

#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using Values = std::vector<std::uint16_t>;

GrayImage small_gray() {
  GrayImage image(3, 2);
  image.pixels() = {0, 10, 35, 254, 255, 205};  // 10 and 35 look like a line end and a comment
  return image;
}

TEST(Pgm, ReadsBackWhatWasWritten) {
  const TemporaryFolder folder;
  write_pgm(folder.file("a.pgm"), small_gray());
  const Samples samples = read_samples(folder.file("a.pgm"));
  EXPECT_EQ(samples.width, 3);
  EXPECT_EQ(samples.height, 2);
  EXPECT_EQ(samples.channels, 1);
  EXPECT_EQ(samples.white, 255);
  EXPECT_EQ(samples.values, (Values{0, 10, 35, 254, 255, 205}));
}

TEST(Pgm, HasTheHeaderThatMapServersRead) {
  EXPECT_EQ(pgm_of(GrayImage(2, 1, 'x')), "P5\n2 1\n255\nxx");
}

TEST(Pgm, ReadsTextCommentsAndOtherRanges) {
  const Samples plain = samples_from("P2 # by hand\n# two pixels\n2 1 15\n0 15\n", "x.pgm");
  EXPECT_EQ(plain.white, 15);
  EXPECT_EQ(plain.values, (Values{0, 15}));
  const Samples wide = samples_from(std::string("P5 2 1 1000\n\x03\xe8\x00\x07", 16), "x.pgm");
  EXPECT_EQ(wide.white, 1000);
  EXPECT_EQ(wide.values, (Values{1000, 7})) << "two bytes a pixel, the high one first";
}

TEST(Pgm, EveryCutIsNoticed) {
  const std::string pgm = pgm_of(small_gray());
  for (std::size_t size = 0; size < pgm.size(); ++size) {
    EXPECT_INPUT_ERROR(samples_from_pgm(pgm.substr(0, size), "x.pgm"), "x.pgm: ");
  }
  EXPECT_INPUT_ERROR(samples_from_pgm("P5\n1 1\n65535\nx", "x.pgm"), "it was cut short");
}

TEST(Pgm, RefusesWhatIsNoPicture) {
  EXPECT_INPUT_ERROR(samples_from("P6\n1 1\n255\nxxx", "x.pgm"), "neither a PNG nor a PGM");
  EXPECT_INPUT_ERROR(samples_from("", "x.pgm"), "neither a PNG nor a PGM");
  EXPECT_INPUT_ERROR(samples_from("P5\n-1 1\n255\nx", "x.pgm"), "the width is missing or not");
  EXPECT_INPUT_ERROR(samples_from("P5\n1 1\n65536\nxx", "x.pgm"), "not between 1 and 65535");
  EXPECT_INPUT_ERROR(samples_from("P5\n1000000 1000000\n255\nx", "x.pgm"), "it was cut short");
  EXPECT_INPUT_ERROR(samples_from("P5\n1 1\n9\nx", "x.pgm"), "above the largest value");
  EXPECT_INPUT_ERROR(samples_from("P2\n1 1\n255\nx ", "x.pgm"), "a pixel is missing");
}

}  // namespace
}  // namespace mapbed
