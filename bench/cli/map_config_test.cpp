#include "bench/cli/map_config.h"

#include <fstream>

#include <gmock/gmock.h>

#include "core/input_error.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

MapConfig config_of(const std::vector<std::string>& assignments) {
  Settings settings;
  for (const std::string& assignment : assignments) settings.push_back(parse_setting(assignment));
  return map_config_from(settings);
}

auto refuses_with(const std::string& message) {
  return ThrowsMessage<InputError>(HasSubstr(message));
}

TEST(MapConfig, GivesEachSettingToItsOwner) {
  const MapConfig config = config_of({"method=odometry", "seed=7", "log.max_range=50 m",
                                      "map.resolution=10 cm", "odometry.longest_gap=3 s"});
  EXPECT_EQ(config.seed, 7U);
  EXPECT_EQ(config.log.max_range, 50.0);
  EXPECT_EQ(config.map.resolution, 0.1);
  EXPECT_THAT(config.configured.complete_yaml, HasSubstr("longest_gap: 3 s"));
}

TEST(MapConfig, RefusesWhatNobodyTakes) {
  EXPECT_THAT([] { config_of({"mapp.resolution=10 cm"}); }, refuses_with("unknown key 'mapp'"));
  EXPECT_THAT([] { config_of({"map.resolutoin=10 cm"}); },
              refuses_with("unknown key 'resolutoin' in map; did you mean 'resolution'?"));
  EXPECT_THAT(
      [] {
        config_of({"method=odometry", "odometry.longest_gapp=1 s"});
      },
      refuses_with("unknown key 'longest_gapp' in odometry"));
  EXPECT_THAT([] { config_of({"method=odometri"}); }, refuses_with("unknown method 'odometri'"));
  EXPECT_THAT(
      [] {
        config_of({"method=odometry", "odometry=3"});
      },
      refuses_with("'odometry' has keys and takes no value"));
}

TEST(MapConfig, TellsWhereAnOptionOfTheMethodBelongs) {
  EXPECT_THAT(
      [] {
        config_of({"particles=30", "method=rbpf"});
      },
      refuses_with("'particles' is an option of the method rbpf; write 'rbpf.particles'"));
  EXPECT_THAT(
      [] {
        config_of({"method=rbpf", "likelihood.sigma=5 cm"});
      },
      refuses_with("write 'rbpf.likelihood.sigma'"));
  EXPECT_THAT(
      [] {
        config_of({"method=odometry", "particles=30"});
      },
      refuses_with("unknown key 'particles'"));
}

TEST(MapConfig, RefusesWrongUnitsAndSizesThatMakeNoSense) {
  EXPECT_THAT([] { config_of({"map.resolution=2 kg"}); }, refuses_with("'2 kg' is not a length"));
  EXPECT_THAT([] { config_of({"map.resolution=-5 cm"}); }, refuses_with("resolution"));
  EXPECT_THAT([] { config_of({"map.resolution=nan"}); }, refuses_with("nan"));
  EXPECT_THAT([] { config_of({"map.resolution=5"}); }, refuses_with("5"));
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
