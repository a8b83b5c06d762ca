#include "core/image/dilation.h"

#include <string>

#include <gtest/gtest.h>

namespace mapbed {
namespace {

std::string drawing_of(const GrayImage& image) {
  std::string text;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) text += image.at(x, y) == 1 ? '#' : '.';
    text += '|';
  }
  return text;
}

GrayImage with_marks() {
  GrayImage marks(6, 4);
  marks.at(1, 1) = 1;
  marks.at(5, 3) = 1;
  return marks;
}

TEST(Dilation, GrowsMarksToSquares) {
  EXPECT_EQ(drawing_of(dilated(with_marks(), 0)), "......|.#....|......|.....#|");
  EXPECT_EQ(drawing_of(dilated(with_marks(), 1)), "###...|###...|###.##|....##|");
  EXPECT_EQ(drawing_of(dilated(with_marks(), 2)), "####..|######|######|######|");
}

TEST(Dilation, OfNothingIsNothing) {
  EXPECT_EQ(dilated(GrayImage(), 3), GrayImage());
  EXPECT_EQ(dilated(GrayImage(2, 2), 3), GrayImage(2, 2));
}

}  // namespace
}  // namespace mapbed
