#include "algorithms/people/people_number.h"

#include <cmath>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mapbed {
namespace {

TEST(FeatureNumbers, OfTheClosedFormSumUpToOne) {
  const FeatureNumbers numbers = FeatureNumbers::closed_form(0.8, 0.5, 6);
  for (int n = 0; n <= 6; ++n) {
    double sum = 0.0;
    for (int m = 0; m <= 22; ++m) sum += numbers.probability(m, n);
    EXPECT_NEAR(sum, 1.0, 1e-4) << n;
  }
}

TEST(FeatureNumbers, OfTheClosedFormAreBinomialWithoutFalseAlarms) {
  const FeatureNumbers numbers = FeatureNumbers::closed_form(0.8, 0.0, 3);
  EXPECT_NEAR(numbers.probability(2, 3), 3 * 0.8 * 0.8 * 0.2, 1e-12);
  EXPECT_NEAR(numbers.probability(3, 3), 0.8 * 0.8 * 0.8, 1e-12);
}

// (3.5) for at most one person, by hand.
TEST(PeopleNumber, IsBayesRuleWithPeopleWhoComeAndGo) {
  const FeatureNumbers numbers(std::vector<std::vector<double>>{{0.9, 0.1}, {0.3, 0.7}});
  const double seconds = 0.5;
  PeopleNumber number(numbers, {.change_rate = 1.0});
  number.add(1, seconds);
  EXPECT_NEAR(number.density()[1], 0.7 / 0.8, 1e-12);  // half and half before, and after a change
  number.add(1, seconds);
  const double change = 0.5 * (1.0 - std::exp(-seconds));
  const double one = (1.0 - change) * 0.875 + change * 0.125;
  EXPECT_NEAR(number.density()[1], one * 0.7 / (one * 0.7 + (1.0 - one) * 0.1), 1e-12);
}

TEST(PeopleNumber, FollowsWhatIsCounted) {
  PeopleNumber number(FeatureNumbers::closed_form(0.9, 0.2, 20), {.change_rate = 1.0});
  for (int i = 0; i < 20; ++i) number.add(5, 0.1);
  EXPECT_EQ(number.most_likely(), 5);
  number.add(4, 0.1);
  EXPECT_EQ(number.most_likely(), 5) << "one is missed at times";
  for (int i = 0; i < 60; ++i) number.add(2, 0.1);
  EXPECT_EQ(number.most_likely(), 2);
}

TEST(PeopleNumber, StaysFiniteWhateverIsCounted) {
  PeopleNumber number(FeatureNumbers::closed_form(0.9, 0.2, 10), {});
  for (const int m : {0, 1000, 0, 1'000'000}) {
    number.add(m, 1e6);
    EXPECT_NEAR(std::accumulate(number.density().begin(), number.density().end(), 0.0), 1.0, 1e-9);
  }
}

}  // namespace
}  // namespace mapbed
