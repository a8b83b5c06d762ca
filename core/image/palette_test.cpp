#include "core/image/palette.h"

#include <gtest/gtest.h>

namespace mapbed {
namespace {

constexpr Rgb kOrange{230, 159, 0};

TEST(Palette, GivesItsOwnColorsThemselves) {
  const Palette palette({kWhite, kBlack, kOrange, {252, 252, 252}});
  EXPECT_EQ(palette.nearest(kWhite), kWhite) << "the first of two that differ in their last bits";
  EXPECT_EQ(palette.nearest(kBlack), kBlack);
  EXPECT_EQ(palette.nearest(kOrange), kOrange);
  EXPECT_EQ(palette.index_of(kOrange), 2);
}

TEST(Palette, GivesTheNearestOfAllOthers) {
  const Palette palette({kWhite, kBlack, kOrange});
  EXPECT_EQ(palette.nearest({60, 60, 60}), kBlack);
  EXPECT_EQ(palette.nearest({200, 210, 205}), kWhite);
  EXPECT_EQ(palette.nearest({220, 140, 20}), kOrange);
}

}  // namespace
}  // namespace mapbed
