#include "core/config/permitted_values.h"

#include <gmock/gmock.h>

#include "core/config/settings.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

enum class Taste : int { sweet, sour };
struct Cake {
  Taste taste = Taste::sweet;
  double height = 0.1;  // [m]
  double angle = 0.5;   // [rad]
  double sugar = 0.5;
  int candles = 3;
  double anything = 1.0;
  bool iced = false;
  std::string name = "cake";
};

template <class Visitor>
void visit_fields(Cake& o, Visitor&& visit) {
  visit("taste", o.taste, {"sweet", "sour"}, "how it is");
  visit("height", o.height, Unit::meter, kPositive, "of all layers");
  visit("angle", o.angle, Unit::radian, between(0.0, 3.141592653589793), "of a piece");
  visit("sugar", o.sugar, kFraction, "of its mass");
  visit("candles", o.candles, at_least(1), "on top");
  visit("anything", o.anything, "else");
  visit("iced", o.iced, "on top");
  visit("name", o.name, "on the label");
}

TEST(PermittedValues, AreToldOfEveryKindOfOption) {
  Cake cake;
  const PermittedValuesShown shown;
  const std::string yaml = to_yaml(options_of(cake));
  EXPECT_THAT(yaml, HasSubstr("taste: sweet  # how it is; one of sweet, sour\n"));
  EXPECT_THAT(yaml, HasSubstr("# of all layers; above 0 m\n"));
  EXPECT_THAT(yaml, HasSubstr("# of a piece; from 0 deg to 180 deg\n"));
  EXPECT_THAT(yaml, HasSubstr("# of its mass; from 0 to 1\n"));
  EXPECT_THAT(yaml, HasSubstr("candles: 3  # on top; 1 or more\n"));
  EXPECT_THAT(yaml, HasSubstr("anything: 1  # else\n"));
  EXPECT_THAT(yaml, HasSubstr("iced: false  # on top; true or false\n"));
  EXPECT_THAT(yaml, HasSubstr("name: cake  # on the label\n"));
}

TEST(PermittedValues, StandInNoConfigurationThatIsWritten) {
  Cake cake;
  { const PermittedValuesShown shown; }
  EXPECT_THAT(to_yaml(options_of(cake)), Not(HasSubstr("one of")));
}

}  // namespace
}  // namespace mapbed
