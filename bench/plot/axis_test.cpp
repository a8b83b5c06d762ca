#include "bench/plot/axis.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string> texts_of(const std::vector<Tick>& ticks) {
  std::vector<std::string> texts;
  for (const Tick& tick : ticks) {
    if (!tick.text.empty()) texts.push_back(tick.text);
  }
  return texts;
}

TEST(Ticks, AreFewHoweverLargeAndHoweverNearTheNumbers) {
  for (const double size : {1e-300, 1.0, 1e17, 1e300, -1e300}) {
    for (const double other : {size, std::nextafter(size, 0.0), std::nextafter(size, 2.0 * size)}) {
      const std::vector<double> values{size, other};
      EXPECT_LE(ticks_of(scale_of(Axis{}, values), 5).size(), 16u) << size << " " << other;
    }
  }
  EXPECT_LE(ticks_of(Scale{1e17, 1e17 + 16.0}, 5).size(), 16u);
  const std::vector<double> apart{1e-300, 1e300};
  EXPECT_LE(ticks_of(scale_of(Axis{.logarithmic = true}, apart), 5).size(), 308u) << "a decade";
}

TEST(Ticks, StandAtRoundNumbers) {
  EXPECT_THAT(texts_of(ticks_of(Scale{0.0, 1.0}, 5)),
              ElementsAre("0.0", "0.2", "0.4", "0.6", "0.8", "1.0"));
  EXPECT_THAT(texts_of(ticks_of(Scale{-7.0, 12.0}, 5)), ElementsAre("\u22125", "0", "5", "10"));
  EXPECT_THAT(texts_of(ticks_of(Scale{0.031, 0.051}, 4)),
              ElementsAre("0.035", "0.040", "0.045", "0.050"));
}

TEST(Ticks, OfALogarithmicScaleAreDecadesAndTheirParts) {
  EXPECT_THAT(texts_of(ticks_of(Scale{0.009, 110.0, true}, 6)),
              ElementsAre("0.01", "0.1", "1", "10", "100"));
  EXPECT_THAT(texts_of(ticks_of(Scale{1.0, 10.0, true}, 6)), ElementsAre("1", "2", "5", "10"));
  EXPECT_THAT(texts_of(ticks_of(Scale{1e-9, 1e9, true}, 6)),
              ElementsAre("1e\u221209", "1e\u221206", "0.001", "1", "1000", "1e+06", "1e+09"));
}

TEST(Ticks, NeverLieOutsideTheScaleAndAreNeitherManyNorFew) {
  for (double size = 1e-6; size < 1e7; size *= 3.7) {
    for (const Scale& scale : {Scale{0.0, size}, Scale{-0.3 * size, size}, Scale{size, 1.5 * size},
                               Scale{size, 30 * size, true}}) {
      const std::vector<Tick> ticks = ticks_of(scale, 6);
      for (const Tick& tick : ticks) {
        EXPECT_GE(scale.fraction(tick.value), -1e-6);
        EXPECT_LE(scale.fraction(tick.value), 1.0 + 1e-6);
      }
      EXPECT_GE(texts_of(ticks).size(), 2u) << scale.low << " to " << scale.high;
      EXPECT_LE(texts_of(ticks).size(), 8u) << scale.low << " to " << scale.high;
    }
  }
}

TEST(Scale, HasRoomForAllValuesAndBeginsAtZeroWhereTheyComeNearIt) {
  const Scale near = scale_of({}, std::vector<double>{1.0, 10.0, kNaN});
  EXPECT_EQ(near.low, 0.0);
  EXPECT_GT(near.high, 10.0);
  const Scale far = scale_of({}, std::vector<double>{100.0, 101.0});
  EXPECT_GT(far.low, 99.0);
  const Scale bars = scale_of({}, std::vector<double>{100.0, 101.0}, /*from_zero=*/true);
  EXPECT_EQ(bars.low, 0.0);
}

TEST(Scale, OfALogarithmHasNoPlaceForZero) {
  const Scale scale = scale_of({.logarithmic = true}, std::vector<double>{0.0, -1.0, 0.1, 10.0});
  EXPECT_GT(scale.low, 0.05);
  EXPECT_TRUE(std::isnan(scale.fraction(0.0)));
  EXPECT_NEAR(scale.fraction(1.0), 0.5, 1e-12) << "in the middle between 0.1 and 10";
  EXPECT_NEAR(scale.value(0.5), 1.0, 1e-12);
}

TEST(Scale, OfOneValueOrNoneIsNotEmpty) {
  for (const bool logarithmic : {false, true}) {
    for (const std::vector<double>& values :
         {std::vector<double>{}, {kNaN}, {3.0}, {3.0, 3.0}, {1e-12}}) {
      const Scale scale = scale_of({.logarithmic = logarithmic}, values);
      EXPECT_GT(scale.high, scale.low);
    }
  }
  EXPECT_GT(scale_of({.low = 5.0}, std::vector<double>{1.0, 2.0}).high, 5.0);
}

TEST(NumberText, IsWhatPeopleWrite) {
  EXPECT_EQ(number_text(0.05), "0.05");
  EXPECT_EQ(number_text(12345.6), "12346");
  EXPECT_EQ(number_text(1.5), "1.5");
  EXPECT_EQ(number_text(100.0), "100");
  EXPECT_EQ(number_text(-2.0), "\u22122");
  EXPECT_EQ(number_text(kNaN), "\u2013");
}

}  // namespace
}  // namespace mapbed
