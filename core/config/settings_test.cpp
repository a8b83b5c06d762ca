#include "core/config/settings.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "core/config/config_node.h"
#include "core/geometry/angle.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

enum class Model { odds, counting };

struct NoiseOptions {
  double rotation_sigma = radians(1);
  double translation_sigma = 0.01;
};

template <class Visitor>
void visit_fields(NoiseOptions& o, Visitor&& visit) {
  visit("rotation_sigma", o.rotation_sigma, Unit::radian, kNotNegative, "sigma of the heading");
  visit("translation_sigma", o.translation_sigma, Unit::meter, kNotNegative, "sigma: forward");
}

struct RobotOptions {
  double size = 0.1;
  double fraction = 0.25;
  int beams = 181;
  std::uint64_t seed = 18446744073709551615u;
  bool reverse = false;
  std::string name = "b21r";
  NoiseOptions odometry;
  std::vector<double> levels = {radians(1), 1.0 / 3};
  std::vector<int> counts = {1, -2};
  std::vector<std::string> tags = {"a, b", "", "null", "x: y", "tab\t\"quote\"", "50 %"};
  Model model = Model::odds;
};

template <class Visitor>
void visit_fields(RobotOptions& o, Visitor&& visit) {
  visit("size", o.size, Unit::meter, kPositive, "edge length");
  visit("fraction", o.fraction, kFraction, "how many");
  visit("beams", o.beams, at_least(1), "beams of a scan");
  visit("seed", o.seed, "");
  visit("reverse", o.reverse, "mounted upside down");
  visit("name", o.name, "what it is called");
  visit("odometry", o.odometry, "its noise");
  visit("levels", o.levels, Unit::radian, "steps");
  visit("counts", o.counts, "whole numbers");
  visit("tags", o.tags, "texts");
  visit("model", o.model, {"odds", "counting"}, "of the map");
}

RobotOptions robot_with(const Settings& settings) {
  RobotOptions robot;
  apply(settings, options_of(robot), "robot");
  return robot;
}

RobotOptions robot_from(std::string_view yaml) {
  return robot_with(settings_of(parse_config(yaml, {"x.yaml", 1})));
}

TEST(Settings, SayOnlyWhatDiffersFromTheDefaults) {
  const RobotOptions robot = robot_from(
      "size: 20 cm\n"
      "odometry:\n"
      "  rotation_sigma: 2 deg\n"
      "model: counting\n"
      "levels: [0, 5 deg]\n"
      "tags: [one, 'two, three']\n");
  EXPECT_EQ(robot.size, 0.2);
  EXPECT_EQ(robot.odometry.rotation_sigma, radians(2));
  EXPECT_EQ(robot.odometry.translation_sigma, 0.01);
  EXPECT_EQ(robot.model, Model::counting);
  EXPECT_EQ(robot.levels, (std::vector<double>{0, radians(5)}));
  EXPECT_EQ(robot.tags, (std::vector<std::string>{"one", "two, three"}));
  EXPECT_EQ(robot.beams, 181);
}

TEST(Settings, NestedAndDottedPathsAreTheSame) {
  EXPECT_EQ(robot_from("odometry.rotation_sigma: 2 deg").odometry.rotation_sigma, radians(2));
  EXPECT_EQ(robot_with({parse_setting("odometry.rotation_sigma=2 deg")}).odometry.rotation_sigma,
            radians(2));
  EXPECT_INPUT_ERROR(robot_from("odometry.rotation_sigma: 2 deg\nodometry: {rotation_sigma: 0}"),
                     "x.yaml:2: 'odometry.rotation_sigma' was already set in line 1");
}

TEST(Settings, AListInAGroupCountsAsUsedWithAllItsEntries) {
  const ConfigNode node = parse_config("a: {times: [340 s, 430 s]}", {"x.yaml", 1});
  const Settings settings = settings_of(node.at("a"));
  ASSERT_EQ(settings.size(), 1U);
  EXPECT_EQ(settings[0].text, "[340 s, 430 s]");
  EXPECT_NO_THROW(node.check_all_used());
}

TEST(Settings, TheLaterOfTwoWins) {
  EXPECT_EQ(robot_with({parse_setting("beams=3"), parse_setting("beams=5")}).beams, 5);
}

TEST(Settings, TheCompleteConfigurationReadsBackExactly) {
  RobotOptions odd;
  odd.size = 0.1 + 0.2;
  odd.fraction = 5e-324;
  odd.reverse = true;
  odd.name = "# [no] 'comment': {} \\ \x01 é";
  odd.odometry.rotation_sigma = 1.0 / 3;
  odd.tags = {"-",  "- a", "---", "*a", "&a",   "!t",          "@", "`", "%", "a #b",
              "a:", " a ", "1e3", "~",  "true", "line\nbreak", "?", "|", ">"};
  odd.counts = {};
  odd.model = Model::counting;
  for (RobotOptions options : {RobotOptions{}, odd}) {
    const std::string yaml = to_yaml(options_of(options));
    RobotOptions again = robot_from(yaml);
    EXPECT_EQ(again.size, options.size);
    EXPECT_EQ(again.fraction, options.fraction);
    EXPECT_EQ(again.seed, options.seed);
    EXPECT_EQ(again.reverse, options.reverse);
    EXPECT_EQ(again.name, options.name);
    EXPECT_EQ(again.odometry.rotation_sigma, options.odometry.rotation_sigma);
    EXPECT_EQ(again.odometry.translation_sigma, options.odometry.translation_sigma);
    EXPECT_EQ(again.levels, options.levels);
    EXPECT_EQ(again.counts, options.counts);
    EXPECT_EQ(again.tags, options.tags);
    EXPECT_EQ(again.model, options.model);
    EXPECT_EQ(to_yaml(options_of(again)), yaml);
  }
}

TEST(Settings, TheCompleteConfigurationTellsUnitsAndMeaning) {
  NoiseOptions noise;
  EXPECT_EQ(to_yaml(options_of(noise)),
            "rotation_sigma: 1 deg  # sigma of the heading\n"
            "translation_sigma: 0.01 m  # sigma: forward\n");
}

TEST(Settings, EveryLineOfATextIsIndented) {
  EXPECT_EQ(indented("a: 1\n  b: 2\n"), "  a: 1\n    b: 2\n");
  EXPECT_EQ(indented("a: 1", 4), "    a: 1\n");
  EXPECT_EQ(indented(""), "");
}

TEST(Settings, AnUnknownKeyIsRefusedWithTheNearestOne) {
  EXPECT_INPUT_ERROR(
      robot_from("size: 1 m\nodometry:\n  rotaton_sigma: 2 deg"),
      "x.yaml:3: unknown key 'rotaton_sigma' in robot.odometry; did you mean 'rotation_sigma'?");
  EXPECT_INPUT_ERROR(robot_from("odometri: {rotation_sigma: 0}"),
                     "unknown key 'odometri' in robot; did you mean 'odometry'?");
  EXPECT_INPUT_ERROR(robot_from("odometry: {colour: red}"),
                     "in robot.odometry; known are: rotation_sigma, translation_sigma");
  EXPECT_INPUT_ERROR(robot_from("odometri: {}"), "unknown key 'odometri' in robot");
  EXPECT_INPUT_ERROR(robot_with({parse_setting("bems=3")}),
                     "--set bems=3: unknown key 'bems' in robot; did you mean 'beams'?");
}

TEST(Settings, AGroupIsNoOptionAndAnOptionNoGroup) {
  EXPECT_INPUT_ERROR(robot_from("odometry: 5"), "'odometry' in robot has keys and takes no value");
  EXPECT_INPUT_ERROR(robot_from("size: {x: 1 m}"), "'size' in robot takes one value");
  EXPECT_EQ(robot_from("odometry: {}").odometry.translation_sigma, 0.01);
}

TEST(Settings, AWrongValueIsRefusedWithItsPlace) {
  EXPECT_INPUT_ERROR(robot_from("\nsize: 2 kg"),
                     "x.yaml:2: '2 kg' is not a length; write e.g. '2 m'");
  EXPECT_INPUT_ERROR(robot_from("size: .nan"), "is not a number");
  EXPECT_INPUT_ERROR(robot_from("size: nan m"), "not a finite number");
  EXPECT_INPUT_ERROR(robot_from("size: [1 m]"), "is not a number");
  EXPECT_INPUT_ERROR(robot_from("beams: 1.5"), "x.yaml:1: '1.5' is not a whole number");
  EXPECT_INPUT_ERROR(robot_from("beams: 3000000000"), "too large for a whole number");
  EXPECT_INPUT_ERROR(robot_from("seed: -1"), "cannot be negative");
  EXPECT_INPUT_ERROR(robot_from("reverse: yes"), "write 'true' or 'false'");
  EXPECT_INPUT_ERROR(robot_from("model: oods"),
                     "'oods' is not a choice here; did you mean 'odds'?");
  EXPECT_INPUT_ERROR(robot_from("levels: 5 deg"), "'5 deg' stands where a list should be");
  EXPECT_INPUT_ERROR(robot_from("levels: [5 deg, 2 m]"), "'2 m' is not an angle");
  EXPECT_INPUT_ERROR(robot_from("levels: [[5 deg]]"), "a list stands where one value should be");
  EXPECT_INPUT_ERROR(robot_with({parse_setting("levels=[1 deg")}), "close every bracket");
  EXPECT_INPUT_ERROR(robot_with({parse_setting("levels=[1 deg] junk")}), "--set levels=");
}

TEST(Settings, AValueOutOfBoundsIsRefusedWithTheBounds) {
  EXPECT_INPUT_ERROR(robot_from("size: -2 m"),
                     "x.yaml:1: '-2 m' is too small; it must be more than 0 m");
  EXPECT_INPUT_ERROR(robot_from("size: 0"), "more than 0 m");
  EXPECT_INPUT_ERROR(robot_from("fraction: 1.01"),
                     "too large; it must be at least 0 and at most 1");
  EXPECT_INPUT_ERROR(robot_from("beams: 0"), "it must be at least 1");
  EXPECT_EQ(robot_from("fraction: 1").fraction, 1.0);
  EXPECT_EQ(robot_from("odometry: {rotation_sigma: 0}").odometry.rotation_sigma, 0.0);
}

TEST(Settings, AnAssignmentNeedsAPathAndAnEqualsSign) {
  EXPECT_EQ(parse_setting("a.b=c=d").path, "a.b");
  EXPECT_EQ(parse_setting("a.b=c=d").text, "c=d");
  EXPECT_INPUT_ERROR(parse_setting("a.b"), "--set a.b: there is no '='");
  for (const char* wrong : {"=5", ".a=5", "a.=5", "a..b=5", "a b=5"}) {
    EXPECT_INPUT_ERROR(parse_setting(wrong), "is not the path of an option");
  }
}

TEST(Settings, AFileThatIsNotThereIsNamed) {
  EXPECT_INPUT_ERROR(load_settings("no/such.yaml"), "no/such.yaml: no such file");
  EXPECT_INPUT_ERROR(load_settings(std::filesystem::temp_directory_path().string()), "is a folder");
}

}  // namespace
}  // namespace mapbed
