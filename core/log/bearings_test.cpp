#include "core/log/bearings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "core/log/log_options.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;

// In degrees, as people think of them.
struct Case {
  std::size_t beams;
  StatedBearings stated;
  LogOptions options;
  double first, step;  // [deg] right
};

void expect_right(const Case& c, const BearingsInLog& found) {
  ASSERT_TRUE(found.bearings);
  EXPECT_NEAR(degrees(found.bearings->first), c.first, 1e-3);
  EXPECT_NEAR(degrees(found.bearings->step), c.step, 1e-4);
}

class AreReplaced : public ::testing::TestWithParam<Case> {};

TEST_P(AreReplaced, EachOptionReplacesItsOwnQuantityAlone) {
  const Case& c = GetParam();
  expect_right(c, bearings_of(c.beams, c.stated, c.options));
}

INSTANTIATE_TEST_SUITE_P(
    Bearings, AreReplaced,
    ::testing::Values(
        Case{360, {}, {.first_bearing = {-kPi}}, -180, 0.5},
        Case{181, {}, {.first_bearing = {0.0}}, 0, 1},
        Case{361, {.resolution = 0.5, .field_of_view = 180}, {.first_bearing = {0.5}}, 28.648, 0.5},
        Case{361, {.resolution = 0.5, .field_of_view = 180}, {.bearing_step = 0.01}, -90, 0.57296},
        Case{361, {.resolution = 0.5}, {.field_of_view = radians(270)}, -135, 0.75},
        Case{360, {}, {.field_of_view = radians(360)}, -180, 1},
        Case{361, {}, {.field_of_view = radians(360)}, -180, 1},
        Case{97, {}, {.bearing_step = radians(1)}, -48, 1},
        Case{97, {}, {.field_of_view = radians(96), .first_bearing = {0.0}}, 0, 1}));

class FitEachOther : public ::testing::TestWithParam<Case> {};

TEST_P(FitEachOther, StatementsInDegreesOrInRadians) {
  const Case& c = GetParam();
  expect_right(c, bearings_of(c.beams, c.stated, c.options));
  EXPECT_TRUE(bearings_of(c.beams, c.stated, c.options).candidates.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Bearings, FitEachOther,
    ::testing::Values(
        Case{361, {.resolution = 0.5, .field_of_view = 180}, {}, -90, 0.5},
        Case{180, {.resolution = 1, .field_of_view = 180}, {}, -90, 1},
        Case{360, {.resolution = 1, .field_of_view = 360}, {}, -180, 1},
        Case{360, {.field_of_view = 360}, {}, -180, 1},
        Case{361, {.resolution = 0.5, .field_of_view = 3.14159}, {}, -90, 0.5},
        Case{541, {.resolution = 0.00872665, .field_of_view = 4.712389}, {}, -135, 0.5},
        Case{1081, {.resolution = 0.00436332, .field_of_view = 270}, {}, -135, 0.25},
        Case{181, {.field_of_view = 3.14159}, {}, -90, 1},
        Case{181, {.resolution = 0.0174533}, {}, -90, 1},
        Case{5, {.resolution = 0.7, .first = radians(-40)}, {}, -40, 0.7}));

TEST(Bearings, RadiansAreTold) {
  EXPECT_EQ(bearings_of(361, {.resolution = 0.5, .field_of_view = 3.14159}, {}).note,
            "fov 3.14159 is taken as radians (180 deg)");
  EXPECT_EQ(bearings_of(181, {.resolution = 0.0174533}, {}).note,
            "resolution 0.0174533 is taken as radians (1 deg)");
  EXPECT_EQ(bearings_of(361, {.resolution = 0.5, .field_of_view = 180}, {}).note, "");
  EXPECT_EQ(bearings_of(181, {.field_of_view = 700}, {}).note,
            "fov 700 makes no sense and is not used");
}

TEST(Bearings, StatementsThatContradictEachOtherAreToldAndLeaveBothPossible) {
  const BearingsInLog half = bearings_of(361, {.resolution = 1, .field_of_view = 180}, {});
  EXPECT_NEAR(degrees(half.bearings->step), 0.5, 1e-9);  // as a laser of 361 beams has it
  ASSERT_EQ(half.candidates.size(), 1u);
  EXPECT_NEAR(degrees(half.candidates[0].first), -180.0, 1e-9);
  EXPECT_EQ(half.note,
            "resolution 1 deg and fov 180 deg do not fit 361 beams: 0.5 deg from -90 deg is taken");
  const BearingsInLog none = bearings_of(200, {.resolution = 0.5, .field_of_view = 180}, {});
  EXPECT_EQ(none.candidates.size(), 2u);
  EXPECT_THAT(none.note, HasSubstr("do not fit 200 beams"));
  EXPECT_TRUE(bearings_of(361, {.resolution = 1, .field_of_view = 180}, {.bearing_step = 0.01})
                  .candidates.empty());
}

TEST(Bearings, ANumberOfBeamsAloneLeavesTheFullCirclePossible) {
  const BearingsInLog found = bearings_of(360, {}, {});
  EXPECT_EQ(found.source, "the number of beams, 360");
  ASSERT_EQ(found.candidates.size(), 2u);
  for (const Bearings& candidate : found.candidates) EXPECT_TRUE(is_full_circle(candidate, 360));
  EXPECT_FALSE(bearings_of(97, {}, {}).bearings);
  EXPECT_EQ(bearings_of(1440, {}, {}).candidates.size(), 1u);  // taken as a circle from the back
}

TEST(Bearings, ANeighbouringNumberOfBeamsDividesTheSameCircle) {
  for (const std::size_t beams : {358u, 361u, 370u}) {
    const auto near = bearings_of_neighbour(beams, {-kPi, radians(1)}, 360);
    ASSERT_TRUE(near);
    EXPECT_EQ(near->first, -kPi);
    EXPECT_NEAR(near->step * static_cast<double>(beams), 2 * kPi, 1e-12);
  }
  EXPECT_LT(bearings_of_neighbour(358, {kPi, radians(-1)}, 360)->step, 0.0);
}

TEST(Bearings, OfLessThanACircleANeighbouringNumberOfBeamsIsCutOff) {
  const Bearings half{-kPi / 2, radians(0.5)};
  EXPECT_EQ(bearings_of_neighbour(358, half, 361), half);
  EXPECT_EQ(bearings_of_neighbour(361, half, 360), half);
  EXPECT_FALSE(bearings_of_neighbour(181, half, 361));
}

TEST(Bearings, OfALineAreRadiansUnlessTheseAreTooLarge) {
  const auto expect = [](const LineBearings& line, double first, double step) {
    EXPECT_NEAR(degrees(line.bearings.first), first, 1e-6);
    EXPECT_NEAR(degrees(line.bearings.step), step, 1e-6);
    EXPECT_FALSE(line.other);
  };
  expect(bearings_of_line(-kPi / 2, kPi, radians(1), 181), -90, 1);
  expect(bearings_of_line(-kPi, 2 * kPi, radians(1), 360), -180, 1);
  expect(bearings_of_line(-90, 180, 1, 181), -90, 1);
  expect(bearings_of_line(-180, 359, 1, 360), -180, 1);
  expect(bearings_of_line(-90, 180, radians(0.5), 361), -90, 0.5);
  expect(bearings_of_line(-kPi / 2, kPi, 0.5, 361), -90, 0.5);
  expect(bearings_of_line(kPi / 2, kPi, radians(-1), 181), 90, -1);
  expect(bearings_of_line(-kPi / 2, kPi, 0, 181), -90, 1);
  EXPECT_EQ(bearings_of_line(-90, 180, 1, 181).note,
            "first bearing, field of view, step taken as degrees, too large for radians");
}

TEST(Bearings, OfALineThatContradictsItselfTheStepCounts) {
  const LineBearings line = bearings_of_line(-kPi / 2, kPi, radians(1), 361);
  EXPECT_EQ(line.bearings, (Bearings{-kPi / 2, radians(1)}));
  ASSERT_TRUE(line.other);
  EXPECT_NEAR(degrees(line.other->step), 0.5, 1e-9);
  EXPECT_THAT(line.note, HasSubstr("do not fit the number of beams"));
}

}  // namespace
}  // namespace mapbed
