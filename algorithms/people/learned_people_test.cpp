#include "algorithms/people/learned_people.h"

#include <gtest/gtest.h>

namespace mapbed {
namespace {

TEST(LearnedFeatureNumbers, AreDistributionsForAnyNumberOfPeople) {
  const FeatureNumbers numbers = learned_feature_numbers(0.9, 0.05, 40);
  ASSERT_EQ(numbers.max_people(), 40);
  for (int n = 0; n <= 40; ++n) {
    double sum = 0.0;
    for (int m = 0; m <= numbers.max_features(); ++m) sum += numbers.probability(m, n);
    EXPECT_NEAR(sum, 1.0, 2e-4) << n;
  }
}

TEST(LearnedFeatureNumbers, AreTheClosedFormWhereNobodyCounted) {
  const FeatureNumbers numbers = learned_feature_numbers(0.9, 0.05, 40);
  const FeatureNumbers form = FeatureNumbers::closed_form(0.9, 0.05, 40);
  for (const int m : {20, 27, 30}) {
    EXPECT_NEAR(numbers.probability(m, 30), form.probability(m, 30), 1e-5);
  }
}

TEST(LearnedFeatureNumbers, SayAsManyPeopleAsFeatures) {
  PeopleNumber number(learned_feature_numbers(0.9, 0.05, 40), {});
  for (int i = 0; i < 30; ++i) number.add(4, 0.1);
  EXPECT_EQ(number.most_likely(), 4);
}

TEST(Evidence, ForAPersonIsToComeToWhatWasFreeAndToLeaveNothingBehind) {
  const Evidence walks{Evidence::Kind::step, SeenBefore::free, Evidence::Left::free, true};
  EXPECT_GT(walks.log_ratio(), 0.0);
  Evidence other = walks;
  other.is_steady = false;
  EXPECT_LT(other.log_ratio(), walks.log_ratio());
  other = walks;
  other.before = SeenBefore::same;
  EXPECT_LT(other.log_ratio(), 0.0);
  other = walks;
  other.left = Evidence::Left::same;
  EXPECT_LT(other.log_ratio(), walks.log_ratio());
  EXPECT_LT((Evidence{Evidence::Kind::stay, SeenBefore::nothing, {}, true}.log_ratio()), 0.0);
  EXPECT_LT((Evidence{Evidence::Kind::missed, {}, {}, true}.log_ratio()), 0.0);
}

}  // namespace
}  // namespace mapbed
