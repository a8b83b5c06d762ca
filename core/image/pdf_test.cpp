#include "core/image/pdf.h"

#include <cstdlib>

#include <gmock/gmock.h>

#include "core/file/text_file.h"
#include "core/image/samples.h"
#include "core/testing/temporary_folder.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

// No two pixels alike, so that a row that is shifted or a channel that is swapped shows.
RgbImage ramp() {
  RgbImage image(40, 30);
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 40; ++x) {
      image.at(x, y) = {static_cast<std::uint8_t>(6 * x), static_cast<std::uint8_t>(8 * y), 77};
    }
  }
  return image;
}

TEST(Pdf, IsAPageOfThePicturesShape) {
  const std::string pdf = pdf_of(ramp(), 25.4);
  EXPECT_THAT(pdf, StartsWith("%PDF-1."));
  EXPECT_THAT(pdf, HasSubstr("/MediaBox [0 0 72.00 54.00]"))
      << "an inch, and three quarters of one";
  EXPECT_EQ(pdf, pdf_of(ramp(), 25.4));
}

TEST(Pdf, ItsTableSaysWhereEachObjectBegins) {
  const std::string pdf = pdf_of(ramp(), 100.0);
  const std::size_t table = std::stoul(pdf.substr(pdf.rfind("startxref\n") + 10));
  ASSERT_EQ(pdf.substr(table, 9), "xref\n0 6\n");
  for (std::size_t object = 1; object <= 5; ++object) {
    const std::size_t at = std::stoul(pdf.substr(table + 9 + 20 * object, 10));
    EXPECT_EQ(pdf.substr(at, 8), std::to_string(object) + " 0 obj\n");
  }
}

TEST(Pdf, AnotherProgramReadsTheSamePixels) {
  if (std::system("command -v pdfimages >/dev/null 2>&1") != 0) GTEST_SKIP() << "no pdfimages here";
  const TemporaryFolder folder;
  write_text_file(folder.file("map.pdf"), pdf_of(ramp(), 100.0));
  const std::string command = "cd '" + folder.file("") + "' && pdfimages -png map.pdf map 2>&1";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const Samples read = read_samples(folder.file("map-000.png"));
  ASSERT_EQ(read.width, 40);
  ASSERT_EQ(read.channels, 3);
  const RgbImage written = ramp();
  for (int i = 0; i < 40 * 30; ++i) {
    const Rgb& pixel = written.at(i % 40, i / 40);
    const auto at = static_cast<std::size_t>(3 * i);
    ASSERT_EQ(read.values[at], pixel.red) << i;
    ASSERT_EQ(read.values[at + 1], pixel.green) << i;
    ASSERT_EQ(read.values[at + 2], pixel.blue) << i;
  }
}

}  // namespace
}  // namespace mapbed
