#include "algorithms/people/learned_people.h"

#include <gtest/gtest.h>

#include "core/config/settings.h"
#include "core/data_path.h"
#include "core/file/atomic_file.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

LearnedPeople learned() {
  return load_learned_people("corridor_and_museum");
}

TEST(LearnedFeatureNumbers, AreDistributionsForAnyNumberOfPeople) {
  const FeatureNumbers numbers = learned().feature_numbers(0.9, 0.05, 40);
  ASSERT_EQ(numbers.max_people(), 40);
  for (int n = 0; n <= 40; ++n) {
    double sum = 0.0;
    for (int m = 0; m <= numbers.max_features(); ++m) sum += numbers.probability(m, n);
    EXPECT_NEAR(sum, 1.0, 2e-4) << n;
  }
}

TEST(LearnedFeatureNumbers, AreTheClosedFormWhereNobodyCounted) {
  const FeatureNumbers numbers = learned().feature_numbers(0.9, 0.05, 40);
  const FeatureNumbers form = FeatureNumbers::closed_form(0.9, 0.05, 40);
  for (const int m : {20, 27, 30}) {
    EXPECT_NEAR(numbers.probability(m, 30), form.probability(m, 30), 1e-5);
  }
}

TEST(LearnedFeatureNumbers, CountTheClosedFormAsSoManyScansMore) {
  LearnedPeople people;
  people.scans[1] = {2.0, 8.0};
  people.closed_form = 10.0;
  const double form = FeatureNumbers::closed_form(0.9, 0.05, 3).probability(1, 1);
  EXPECT_NEAR(people.feature_numbers(0.9, 0.05, 3).probability(1, 1), (8 + 10 * form) / 20, 1e-12);
}

TEST(LearnedFeatureNumbers, SayAsManyPeopleAsFeatures) {
  PeopleNumber number(learned().feature_numbers(0.9, 0.05, 40), {});
  for (int i = 0; i < 30; ++i) number.add(4, 0.1);
  EXPECT_EQ(number.most_likely(), 4);
}

TEST(LearnedEvidence, ForAPersonIsToComeToWhatWasFreeAndToLeaveNothingBehind) {
  const LearnedPeople people = learned();
  const Evidence walks{Evidence::Kind::step, SeenBefore::free, Evidence::Left::free, true};
  const double ratio = people.log_ratio(walks);
  EXPECT_GT(ratio, 0.0);
  Evidence other = walks;
  other.is_steady = false;
  EXPECT_LT(people.log_ratio(other), ratio);
  other = walks;
  other.before = SeenBefore::same;
  EXPECT_LT(people.log_ratio(other), 0.0);
  other = walks;
  other.left = Evidence::Left::same;
  EXPECT_LT(people.log_ratio(other), ratio);
  EXPECT_LT(people.log_ratio({Evidence::Kind::stay, SeenBefore::nothing, {}, true}), 0.0);
  EXPECT_LT(people.log_ratio({Evidence::Kind::missed, {}, {}, true}), 0.0);
}

// Small, and each number another.
LearnedPeople numbered() {
  LearnedPeople people;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const double value = static_cast<double>(4 * i + j) / 8.0;
      people.steady_step[i].push_back(value);
      people.unsteady_step[i].push_back(-value);
    }
    people.stay.push_back(-3.0 - static_cast<double>(i));
  }
  people.missed = -9.5;
  people.scans[0] = {7.0, 0.0, 1.0};
  people.scans[1] = {2.0};
  people.closed_form = 5.0;
  return people;
}

class LearnedPeopleFile : public ::testing::Test {
 protected:
  LearnedPeople loaded(const std::string& yaml) {
    write_file(folder_.file("p.yaml"), yaml);
    return load_learned_people(folder_.file("p.yaml"));
  }
  // The file of numbered(), a part of it replaced.
  std::string with(const std::string& from, const std::string& to) {
    std::string yaml = to_yaml(numbered());
    yaml.replace(yaml.find(from), from.size(), to);
    return yaml;
  }

  TemporaryFolder folder_;
};

TEST_F(LearnedPeopleFile, IsReadAsItWasWritten) {
  const LearnedPeople people = loaded(to_yaml(numbered(), {{"stay", "of 3, 4, 5, 6"}}));
  const LearnedPeople expected = numbered();
  EXPECT_EQ(people.steady_step, expected.steady_step);
  EXPECT_EQ(people.unsteady_step, expected.unsteady_step);
  EXPECT_EQ(people.stay, expected.stay);
  EXPECT_EQ(people.missed, expected.missed);
  EXPECT_EQ(people.scans, expected.scans);
  EXPECT_EQ(people.closed_form, expected.closed_form);
}

TEST_F(LearnedPeopleFile, GivesEachEvidenceItsOwnNumber) {
  const LearnedPeople people = loaded(to_yaml(numbered()));
  using Kind = Evidence::Kind;
  using Left = Evidence::Left;
  EXPECT_EQ(people.log_ratio({Kind::step, SeenBefore::free, Left::same, true}), 7.0 / 8.0);
  EXPECT_EQ(people.log_ratio({Kind::step, SeenBefore::mixed, Left::unknown, false}), -9.0 / 8.0);
  EXPECT_EQ(people.log_ratio({Kind::stay, SeenBefore::same, Left::nowhere, true}), -6.0);
  EXPECT_EQ(people.log_ratio({Kind::missed, SeenBefore::free, Left::nowhere, true}), -9.5);
}

TEST_F(LearnedPeopleFile, WithARowOfAnotherSizeIsRefusedWhereItStands) {
  EXPECT_INPUT_ERROR(loaded(with("free: [0.5, 0.625, 0.75, 0.875]", "free: [0.5, 0.625, 0.75]")),
                     "p.yaml:3: 'steady_step.free' has 3 values");
  EXPECT_INPUT_ERROR(loaded(with("-4, -5, -6]", "-4, -5, -6, -7]")), "'stay' has 5 values");
}

TEST_F(LearnedPeopleFile, WithWhatIsNoNumberIsRefused) {
  EXPECT_INPUT_ERROR(loaded(with("missed: -9.5", "missed: seldom")), "seldom");
  EXPECT_INPUT_ERROR(loaded(with("people_1: [2]", "people_1: [-2]")), "-2");
  EXPECT_INPUT_ERROR(loaded(with("people_1: [2]", "people_1: [.nan]")), "nan");
}

TEST_F(LearnedPeopleFile, ThatLacksSomethingIsRefused) {
  EXPECT_INPUT_ERROR(loaded(with("missed: -9.5\n", "")), "has no 'missed'");
  EXPECT_INPUT_ERROR(loaded("missed: 1\n"), "'steady_step.nothing' has 0 values");
  EXPECT_INPUT_ERROR(loaded(with("people_0: [7, 0, 1]", "people_7: [7, 0, 1]")),
                     "has no 'scans.people_0'");
  EXPECT_INPUT_ERROR(loaded(with("people_1: [2]", "people_3: [2]")), "no 'scans.people_2'");
  EXPECT_INPUT_ERROR(loaded(with("missed:", "mised:")), "mised");
}

TEST_F(LearnedPeopleFile, OfEachNameIsRead) {
  const std::vector<std::string> names = data_names("algorithms/people/people_models");
  EXPECT_FALSE(names.empty());
  for (const std::string& name : names) EXPECT_NO_THROW(load_learned_people(name)) << name;
  EXPECT_INPUT_ERROR(load_learned_people("corridor"), "unknown people model 'corridor'");
}

}  // namespace
}  // namespace mapbed
