#include "core/image/png.h"

#include <gtest/gtest.h>

#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using Values = std::vector<std::uint16_t>;

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
  const Samples gray = read_samples(folder.file("gray.png"));
  EXPECT_EQ(gray.width, 16);
  EXPECT_EQ(gray.channels, 1);
  for (std::uint16_t i = 0; i < 256; ++i) EXPECT_EQ(*gray.pixel(i % 16, i / 16), i);
  const Samples color = read_samples(folder.file("color.png"));
  EXPECT_EQ(color.height, 5);
  EXPECT_EQ(color.channels, 3);
  const std::uint16_t* pixel = color.pixel(6, 4);
  EXPECT_EQ((Values{pixel, pixel + 3}), (Values{216, 204, 200}));
}

TEST(Png, TheSamePictureGivesTheSameBytes) {
  EXPECT_EQ(png_of(color_ramp()), png_of(color_ramp()));
}

// One row of pixels as another program would write it: signature, IHDR, PLTE and tRNS where there
// are any, IDAT with the row stored, not compressed.
std::string foreign_png(int width, char bits, char color_type, const std::string& row,
                        const std::string& palette = {}, const std::string& transparent = {}) {
  const auto number = [](std::uint32_t n) {
    std::string text;
    for (int shift = 24; shift >= 0; shift -= 8) text += static_cast<char>(n >> shift & 255);
    return text;
  };
  const auto chunk = [&](const std::string& name, const std::string& data) {
    std::uint32_t crc = 0xffffffff;
    for (const char c : name + data) {
      crc ^= static_cast<unsigned char>(c);
      for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320 : 0);
    }
    return number(static_cast<std::uint32_t>(data.size())) + name + data + number(~crc);
  };
  const std::string filtered = '\0' + row;
  std::uint32_t a = 1, b = 0;  // Adler-32
  for (const char c : filtered) b += a += static_cast<unsigned char>(c);
  const auto size = static_cast<char>(filtered.size());
  const std::string stored = std::string("\x78\x01\x01", 3) + size + '\0' +
                             static_cast<char>(~size) + '\xff' + filtered + number(b << 16 | a);
  return "\x89PNG\r\n\x1a\n" +
         chunk("IHDR", number(static_cast<std::uint32_t>(width)) + number(1) + bits + color_type +
                           std::string(3, '\0')) +
         (palette.empty() ? "" : chunk("PLTE", palette)) +
         (transparent.empty() ? "" : chunk("tRNS", transparent)) + chunk("IDAT", stored) +
         chunk("IEND", "");
}

TEST(Png, SixteenBitsKeepTheirValues) {
  const Samples wide = samples_from(foreign_png(2, 16, 0, std::string("\x12\x34\x00\x05", 4)), "x");
  EXPECT_EQ(wide.white, 65535);
  EXPECT_EQ(wide.values, (Values{0x1234, 5}));
}

TEST(Png, FewBitsGrowToEightAndPalettesToColors) {
  const Samples bits = samples_from(foreign_png(3, 1, 0, "\xa0"), "x");  // 101
  EXPECT_EQ(bits.white, 255);
  EXPECT_EQ(bits.values, (Values{255, 0, 255}));
  const std::string row("\x01\x00", 2);
  const Samples colors = samples_from(foreign_png(2, 8, 3, row, "\x01\x02\x03\x04\x05\x06"), "x");
  EXPECT_EQ(colors.channels, 3);
  EXPECT_EQ(colors.values, (Values{4, 5, 6, 1, 2, 3}));
}

TEST(Png, TransparencyIsAChannelOfItsOwn) {
  const Samples gray = samples_from(foreign_png(1, 8, 4, "\x07\x80"), "x");
  EXPECT_TRUE(gray.has_alpha());
  EXPECT_EQ(gray.values, (Values{7, 128}));
  const std::string nine("\x00\x09", 2);  // grey 9 stands for: transparent
  const Samples keyed = samples_from(foreign_png(2, 8, 0, "\x09\x08", "", nine), "x");
  EXPECT_EQ(keyed.values, (Values{9, 0, 8, 255}));
}

TEST(Png, EveryCutIsNoticed) {
  const std::string png = png_of(color_ramp());
  for (std::size_t size = 0; size < png.size(); ++size) {
    EXPECT_INPUT_ERROR(samples_from_png(png.substr(0, size), "x.png"),
                       "x.png: cannot be read as a PNG picture");
  }
}

TEST(Png, DamageIsNoticed) {
  std::string png = png_of(color_ramp());
  png[png.find("IDAT") + 10] ^= 0x40;
  EXPECT_INPUT_ERROR(samples_from_png(png, "x.png"), "x.png: cannot be read as a PNG picture");
  EXPECT_INPUT_ERROR(samples_from_png("GIF89a and so on", "x.png"), "damaged, cut short or of");
}

TEST(Png, AHugePictureIsRefusedBeforeMemoryIsTakenForIt) {
  // signature, IHDR of 100000 x 100000 8-bit grey with its checksum
  const char header[] =
      "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\x01\x86\xa0\0\x01\x86\xa0\x08\0\0\0\0\x8d\x39\x54\x14"
      "\0\0\0\0IDAT\x35\xaf\x06\x1e";
  EXPECT_INPUT_ERROR(samples_from_png(std::string(header, sizeof header - 1), "x.png"),
                     "x.png: is a picture of 100000 x 100000 pixels");
}

TEST(Png, AFileThatIsNotThereIsNamed) {
  EXPECT_INPUT_ERROR(read_samples("no/such.png"), "no/such.png: no such file");
}

}  // namespace
}  // namespace mapbed
