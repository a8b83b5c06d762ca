#include "core/config/quantity.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

const SourceLocation kPlace{"x.yaml", 3};

double parse(std::string_view text, Unit unit) {
  return parse_quantity(text, unit, kPlace);
}

TEST(Quantity, IsReadInSiAndRadiansToTheLastBit) {
  EXPECT_EQ(parse("2 cm", Unit::meter), 0.02);
  EXPECT_EQ(parse("2cm", Unit::meter), 0.02);
  EXPECT_EQ(parse("29 cm", Unit::meter), 0.29);
  EXPECT_EQ(parse("1.5 km", Unit::meter), 1500.0);
  EXPECT_EQ(parse("-5 deg", Unit::radian), radians(-5));
  EXPECT_EQ(parse("+5 deg", Unit::radian), radians(5));
  EXPECT_EQ(parse("0.1 m/s", Unit::meter_per_second), 0.1);
  EXPECT_EQ(parse("36 km/h", Unit::meter_per_second), 10.0);
  EXPECT_EQ(parse("3 rad/m", Unit::radian_per_meter), 3.0);
  EXPECT_EQ(parse("90 deg/s", Unit::radian_per_second), kPi / 2);
  EXPECT_DOUBLE_EQ(parse("7200 deg/h", Unit::radian_per_second), radians(2));
  EXPECT_EQ(parse("250 ms", Unit::second), 0.25);
  EXPECT_EQ(parse("10 Hz", Unit::hertz), 10.0);
  EXPECT_EQ(parse("500 g", Unit::kilogram), 0.5);
  EXPECT_EQ(parse("1e-3 m", Unit::meter), 1e-3);
  EXPECT_EQ(parse("0.5 m/s^2", Unit::meter_per_second_squared), 0.5);
  EXPECT_EQ(parse("2 kN", Unit::newton), 2000.0);
}

TEST(Quantity, ABareNumberServesWhereThereIsNoUnitAndZeroEverywhere) {
  EXPECT_EQ(parse("2.5", Unit::none), 2.5);
  EXPECT_EQ(parse("0", Unit::meter), 0.0);
  EXPECT_EQ(parse("0.0", Unit::radian), 0.0);
}

TEST(Quantity, AWrongUnitIsRefusedWithAnExample) {
  EXPECT_INPUT_ERROR(parse("2 kg", Unit::meter),
                     "x.yaml:3: '2 kg' is not a length; write e.g. '2 m' or '2 cm'");
  EXPECT_INPUT_ERROR(parse("2 m", Unit::none), "write '2'");
  EXPECT_INPUT_ERROR(parse("2", Unit::radian), "'2' needs a unit: it is an angle; write e.g.");
}

TEST(Quantity, WhatIsNoNumberIsRefused) {
  EXPECT_INPUT_ERROR(parse("far", Unit::meter), "'far' is not a number; write e.g. '2 m'");
  EXPECT_INPUT_ERROR(parse("", Unit::none), "'' is not a number");
  EXPECT_INPUT_ERROR(parse("+-2", Unit::none), "'+-2' is not a number");
  EXPECT_INPUT_ERROR(parse("1 2", Unit::none), "'1 2' is not a number");
  EXPECT_INPUT_ERROR(parse("nan m", Unit::meter), "not a finite number");
  EXPECT_INPUT_ERROR(parse("-inf", Unit::none), "not a finite number");
  EXPECT_INPUT_ERROR(parse("1e999 m", Unit::meter), "too large or too small");
  EXPECT_INPUT_ERROR(parse("1e308 km", Unit::meter), "too large");
}

TEST(Quantity, ItsTextReadsBackAsTheSameBits) {
  for (const Unit unit : {Unit::none, Unit::meter, Unit::radian, Unit::radian_per_second}) {
    for (const double value :
         {0.0, -0.0, 0.1, 1.0 / 3, radians(2), 5e-324, 1.7976931348623157e308}) {
      EXPECT_EQ(parse(quantity_text(value, unit), unit), value) << quantity_text(value, unit);
    }
  }
}

TEST(Quantity, ItsTextHasDegreesWhereTheyAreShorter) {
  EXPECT_EQ(quantity_text(radians(2), Unit::radian), "2 deg");
  EXPECT_EQ(quantity_text(0.1, Unit::radian), "0.1 rad");
  EXPECT_EQ(quantity_text(radians(30), Unit::radian_per_second), "30 deg/s");
  EXPECT_EQ(quantity_text(0.02, Unit::meter), "0.02 m");
}

TEST(Quantity, UnitsAreFoundByTheirSymbol) {
  for (int i = 0; i <= static_cast<int>(Unit::newton); ++i) {
    const auto unit = static_cast<Unit>(i);
    EXPECT_EQ(unit_of_symbol(unit_symbol(unit), {"x.yaml", 3}), unit);
  }
  EXPECT_EQ(unit_symbol(Unit::radian_per_meter), "rad/m");
  EXPECT_INPUT_ERROR(unit_of_symbol("deg", {"x.yaml", 3}),
                     "x.yaml:3: 'deg' is not the symbol of a unit");
}

TEST(Quantity, PeopleReadDegrees) {
  EXPECT_EQ(display_symbol(Unit::radian_per_second), "deg/s");
  EXPECT_NEAR(displayed(kPi, Unit::radian_per_second), 180.0, 1e-13);
  EXPECT_EQ(display_symbol(Unit::meter), "m");
  EXPECT_EQ(displayed(0.02, Unit::meter), 0.02);
  EXPECT_EQ(display_symbol(Unit::none), "");
}

}  // namespace
}  // namespace mapbed
