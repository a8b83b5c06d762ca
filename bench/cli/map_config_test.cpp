#include "bench/cli/map_config.h"

#include <fstream>

#include <gmock/gmock.h>

#include "core/input_error.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;

MapConfig config_of(const std::vector<std::string>& assignments) {
  Settings settings;
  for (const std::string& assignment : assignments) settings.push_back(parse_setting(assignment));
  return map_config_from(settings);
}

void expect_refused(const std::vector<std::string>& assignments, const std::string& message) {
  EXPECT_INPUT_ERROR(config_of(assignments), message);
}

TEST(MapConfig, GivesEachSettingToItsOwner) {
  const MapConfig config = config_of({"method=odometry", "seed=7", "log.max_range=50 m",
                                      "map.resolution=10 cm", "odometry.longest_gap=3 s"});
  EXPECT_EQ(config.seed, 7U);
  EXPECT_EQ(config.log.max_range, 50.0);
  EXPECT_EQ(config.map.resolution, 0.1);
  EXPECT_THAT(config.chosen.complete_yaml, HasSubstr("longest_gap: 3 s"));
}

TEST(MapConfig, RefusesWhatNobodyTakes) {
  expect_refused({"mapp.resolution=10 cm"}, "unknown key 'mapp'");
  expect_refused({"map.resolutoin=10 cm"},
                 "unknown key 'resolutoin' in map; did you mean 'resolution'?");
  expect_refused({"method=odometry", "odometry.longest_gapp=1 s"},
                 "unknown key 'longest_gapp' in odometry");
  expect_refused({"method=odometri"}, "unknown method 'odometri'");
  expect_refused({"method=odometry", "odometry=3"}, "'odometry' has keys and takes no value");
}

TEST(MapConfig, TellsWhereAnOptionOfTheMethodBelongs) {
  expect_refused({"particles=30", "method=rbpf"},
                 "'particles' is an option of the method rbpf; write 'rbpf.particles'");
  expect_refused({"method=rbpf", "likelihood.sigma=5 cm"}, "write 'rbpf.likelihood.sigma'");
  expect_refused({"method=odometry", "particles=30"}, "unknown key 'particles'");
}

TEST(MapConfig, RefusesWrongUnitsAndSizesThatMakeNoSense) {
  expect_refused({"map.resolution=2 kg"}, "'2 kg' is not a length");
  expect_refused({"map.resolution=-5 cm"}, "resolution");
  expect_refused({"map.resolution=nan"}, "nan");
  expect_refused({"map.resolution=5"}, "5");
}

TEST(MapConfig, WrittenOutAndReadAgainIsTheSame) {
  const MapConfig config = config_of({"method=odometry", "seed=7", "map.resolution=3 cm",
                                      "map.model=odds", "odometry.longest_gap=0.3 s"});
  const std::string path = ::testing::TempDir() + "map_config.yaml";
  std::ofstream(path) << to_yaml(config);
  EXPECT_EQ(to_yaml(map_config_from(load_settings(path))), to_yaml(config));
  EXPECT_THAT(to_yaml(config), HasSubstr("longest_gap: 0.3 s"));
}

}  // namespace
}  // namespace mapbed
