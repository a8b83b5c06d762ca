#include "bench/methods/people_filter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/testing/test_room.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;

ChosenMethod matching() {
  return choose_method("scan_matching", {});
}

Settings settings_of(const std::vector<std::string>& assignments) {
  Settings settings;
  for (const std::string& text : assignments) settings.push_back(parse_setting(text));
  return settings;
}

ChosenMethod filtered(const std::vector<std::string>& assignments) {
  Settings settings = settings_of(assignments);
  return with_people_filter(matching(), taken_people_filter(settings));
}

TEST(PeopleFilter, TakesItsOwnSettingsAndLeavesTheOthers) {
  Settings settings = settings_of(
      {"people=3", "people_filter=visibility_vote", "estimator=icp", "people_filter.ratio=2"});
  const Settings taken = taken_people_filter(settings);
  ASSERT_EQ(settings.size(), 2U);
  EXPECT_EQ(settings[0].path, "people");
  EXPECT_EQ(settings[1].path, "estimator");
  ASSERT_EQ(taken.size(), 2U);
  EXPECT_EQ(taken[0].path, "method");
  EXPECT_EQ(taken[1].path, "ratio");
}

TEST(PeopleFilter, WithoutSettingsOrByTheNameNoneThereIsNoFilter) {
  EXPECT_EQ(filtered({}).filter, "");
  EXPECT_EQ(filtered({"people_filter=none"}).filter, "");
  EXPECT_FALSE(filtered({}).labels_beams);
}

TEST(PeopleFilter, StandsInFrontOfTheMethodWithItsOptions) {
  const ChosenMethod method =
      filtered({"people_filter=visibility_vote", "people_filter.ratio=2.5"});
  EXPECT_EQ(method.filter, "visibility_vote");
  EXPECT_TRUE(method.labels_beams);
  EXPECT_THAT(method_yaml(method), HasSubstr("people_filter:\n  method: visibility_vote\n"));
  EXPECT_THAT(method_yaml(method), HasSubstr("  ratio: 2.5"));
  const auto estimator = std::get<ConfiguredMethod>(method.what).make({}, Rng(1));
  const RecordedLog log =
      drive_through(rectangular_room(6.0, 4.0), {{-1.0, 0.0}, {0.0, 0.0}}, {}, Rng(1));
  for (const Measurement& m : log.measurements) estimator->add(m);
  estimator->finish();
  const Estimate estimate = estimator->estimate();
  ASSERT_TRUE(estimate.labels.has_value());
  EXPECT_EQ(estimate.labels->size(), estimate.trajectory.size());
}

TEST(PeopleFilter, WhatWasLearnedOfPeopleIsAFileThatARunIsMadeOf) {
  for (const char* name : {"people", "kalman"}) {
    const ChosenMethod method = filtered({std::string("people_filter=") + name});
    ASSERT_EQ(method.files.size(), 1U);
    EXPECT_THAT(method.files[0].path, EndsWith("people_models/corridor_and_museum.yaml"));
    EXPECT_THAT(method.filter_yaml, HasSubstr("learned: corridor_and_museum"));
  }
  EXPECT_TRUE(filtered({"people_filter=legs"}).files.empty());
  EXPECT_INPUT_ERROR(filtered({"people_filter=people", "people_filter.learned=museum"}),
                     "unknown people model 'museum'");
}

TEST(PeopleFilter, WrongNamesAndOptionsAreTold) {
  EXPECT_INPUT_ERROR(filtered({"people_filter=visibilty_vote"}),
                     "unknown people filter 'visibilty_vote'; did you mean 'visibility_vote'?");
  EXPECT_INPUT_ERROR(filtered({"people_filter=visibility_vote", "people_filter.rato=2"}),
                     "unknown key 'rato' in visibility_vote; did you mean 'ratio'?");
  EXPECT_INPUT_ERROR(filtered({"people_filter=none", "people_filter.ratio=2"}),
                     "'ratio' is set of a people filter, but there is none");
}

}  // namespace
}  // namespace mapbed
