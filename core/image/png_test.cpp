#include "core/image/png.h"

#include <gtest/gtest.h>

#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

// Every level of grey, 16 x 16.
GrayImage gray_ramp() {
  GrayImage image(16, 16);
  for (int i = 0; i < 256; ++i) image.at(i % 16, i / 16) = static_cast<std::uint8_t>(i);
  return image;
}

RgbImage color_ramp() {
  RgbImage image(7, 5);
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 7; ++x) {
      image.at(x, y) = {static_cast<std::uint8_t>(36 * x), static_cast<std::uint8_t>(51 * y), 200};
    }
  }
  return image;
}

TEST(Png, ReadsBackWhatWasWritten) {
  const TemporaryFolder folder;
  write_png(folder.file("gray.png"), gray_ramp());
  write_png(folder.file("color.png"), color_ramp());
  EXPECT_EQ(read_gray_png(folder.file("gray.png")), gray_ramp());
  EXPECT_EQ(read_rgb_png(folder.file("color.png")), color_ramp());
}

TEST(Png, TheSamePictureGivesTheSameBytes) {
  EXPECT_EQ(png_of(color_ramp()), png_of(color_ramp()));
}

TEST(Png, GrayIsReadAsColorAndBack) {
  const RgbImage color = rgb_from_png(png_of(gray_ramp()), "x.png");
  EXPECT_EQ(color.at(5, 4), (Rgb{69, 69, 69}));
  EXPECT_EQ(gray_from_png(png_of(color), "x.png"), gray_ramp());
}

TEST(Png, EveryCutIsNoticed) {
  const std::string png = png_of(color_ramp());
  constexpr std::size_t end_chunk = 12;  // IEND; all pixels are there without it
  for (std::size_t size = 0; size < png.size() - end_chunk - 4; ++size) {
    EXPECT_INPUT_ERROR(rgb_from_png(png.substr(0, size), "x.png"),
                       "x.png: cannot be read as a PNG picture");
  }
}

TEST(Png, DamageIsNoticed) {
  std::string png = png_of(color_ramp());
  png[png.find("IDAT") + 10] ^= 0x40;
  EXPECT_INPUT_ERROR(rgb_from_png(png, "x.png"), "x.png: cannot be read as a PNG picture");
  EXPECT_INPUT_ERROR(rgb_from_png("GIF89a and so on", "x.png"), "damaged, cut short or of another");
}

TEST(Png, AHugePictureIsRefusedBeforeMemoryIsTakenForIt) {
  // signature, IHDR of 100000 x 100000 8-bit grey with its checksum
  const char header[] =
      "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\x01\x86\xa0\0\x01\x86\xa0\x08\0\0\0\0\x8d\x39\x54\x14"
      "\0\0\0\0IDAT\x35\xaf\x06\x1e";
  EXPECT_INPUT_ERROR(gray_from_png(std::string(header, sizeof header - 1), "x.png"),
                     "x.png: is a picture of 100000 x 100000 pixels");
}

TEST(Png, AFileThatIsNotThereIsNamed) {
  EXPECT_INPUT_ERROR(read_gray_png("no/such.png"), "no/such.png: no such file");
}

}  // namespace
}  // namespace mapbed
