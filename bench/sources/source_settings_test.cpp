#include "bench/sources/source_settings.h"

#include <gmock/gmock.h>

namespace mapbed {
namespace {

using ::testing::ElementsAre;

Settings settings(const std::vector<std::string>& lines) {
  Settings all;
  for (const std::string& line : lines) all.push_back(parse_setting(line));
  return all;
}

std::vector<std::string> texts(const Settings& settings) {
  std::vector<std::string> all;
  for (const Setting& setting : settings) all.push_back(setting.path + "=" + setting.text);
  return all;
}

TEST(SourceSettings, AreThoseOfTheLogAndNotOfTheExperiment) {
  const DividedSettings divided = mapbed::divided(settings(
      {"world=office", "estimator=odometry", "robot.odometry.rate=5 Hz", "map.model=odds"}));
  EXPECT_THAT(texts(divided.source), ElementsAre("world=office", "robot.odometry.rate=5 Hz"));
  EXPECT_THAT(texts(divided.experiment), ElementsAre("estimator=odometry", "map.model=odds"));
}

TEST(SourceSettings, OfAFurtherLogSayWhatDiffersFromTheScenariosOwn) {
  const DividedSettings divided = mapbed::divided(
      settings({"world=office", "mapping.path=tour", "people=3", "mapping.people=0"}), {"mapping"});
  EXPECT_THAT(texts(divided.source), ElementsAre("world=office", "people=3"));
  EXPECT_THAT(texts(divided.further.at("mapping")),
              ElementsAre("world=office", "people=3", "path=tour", "people=0"));
  EXPECT_TRUE(divided.experiment.empty());
}

TEST(SourceSettings, OfAFurtherLogOfTheOtherKindStandAlone) {
  const DividedSettings divided =
      mapbed::divided(settings({"log=intel", "log.max_range=20 m", "mapping.world=office",
                                "mapping.robot=pioneer", "checking.log.max_range=5 m"}),
                      {"mapping", "checking"});
  EXPECT_THAT(texts(divided.further.at("mapping")), ElementsAre("world=office", "robot=pioneer"));
  EXPECT_THAT(texts(divided.further.at("checking")),
              ElementsAre("log=intel", "log.max_range=20 m", "log.max_range=5 m"));
  const DividedSettings other = mapbed::divided(
      settings({"world=office", "robot=pioneer", "mapping.log=intel"}), {"mapping"});
  EXPECT_THAT(texts(other.further.at("mapping")), ElementsAre("log=intel"));
}

}  // namespace
}  // namespace mapbed
