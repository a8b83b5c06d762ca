#include "core/config/config_node.h"

#include <gtest/gtest.h>

#include "core/config/yaml_limit.h"
#include "core/geometry/angle.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

ConfigNode read(std::string_view yaml) {
  return parse_config(yaml, {"x.yaml", 1});
}

struct Laser {
  double height = 0.3;
  struct Noise {
    double sigma = 0.01;
  } noise;
};

template <class Visitor>
void visit_fields(Laser::Noise& o, Visitor&& visit) {
  visit("sigma", o.sigma, Unit::meter, kNotNegative, "sigma of a range");
}

template <class Visitor>
void visit_fields(Laser& o, Visitor&& visit) {
  visit("height", o.height, Unit::meter, "above the floor");
  visit("noise", o.noise, "of the ranges");
}

TEST(ConfigNode, ReadsListsOfMapsIntoStructs) {
  const ConfigNode file = read(
      "drive: synchro\n"
      "sensors:\n"
      "  - name: front\n"
      "    height: 40 cm\n"
      "  - {name: rear, noise: {sigma: 2 cm}}\n");
  EXPECT_EQ(file.at("drive").choice({"differential", "synchro"}), 1);
  std::vector<std::string> names;
  std::vector<Laser> lasers;
  for (const ConfigNode& entry : file.at("sensors").items()) {
    names.push_back(entry.at("name").text());
    read_options(entry, options_of(lasers.emplace_back()));
  }
  file.check_all_used();

  EXPECT_EQ(names, (std::vector<std::string>{"front", "rear"}));
  ASSERT_EQ(lasers.size(), 2u);
  EXPECT_EQ(lasers[0].height, 0.4);
  EXPECT_EQ(lasers[1].noise.sigma, 0.02);
  EXPECT_EQ(file.at("sensors").items()[1].place().line, 5);
}

TEST(ConfigNode, RefusesAKeyThatNobodyAskedFor) {
  const ConfigNode file = read("sensors:\n  - name: front\n    noise:\n      sigmma: 2 cm\n");
  Laser laser;
  for (const ConfigNode& entry : file.at("sensors").items()) {
    (void)entry.at("name");
    read_options(entry, options_of(laser));
  }
  EXPECT_INPUT_ERROR(
      file.check_all_used("robot"),
      "x.yaml:4: unknown key 'sigmma' in robot.sensors[0].noise; did you mean 'sigma'?");
}

TEST(ConfigNode, MissingKeysAndWrongKindsAreErrorsWithTheirPlace) {
  const ConfigNode file = read("a: 1\nlist: [x, 3]\nmap:\n  height: 2\n");
  EXPECT_INPUT_ERROR(file.at("map").at("heigth"),
                     "x.yaml:4: key 'heigth' is missing; is 'height' meant to be it?");
  EXPECT_INPUT_ERROR(file.at("a").items(), "x.yaml:1: '1' stands where a list should be");
  EXPECT_INPUT_ERROR(file.at("list").text(), "x.yaml:2: a list stands where one value should be");
  EXPECT_INPUT_ERROR(file.at("list").find("x"), "a list stands where keys with values should be");
  EXPECT_INPUT_ERROR(file.at("list").whole_numbers(), "x.yaml:2: 'x' is not a whole number");
  EXPECT_INPUT_ERROR(file.at("a").number(Unit::meter), "x.yaml:1: '1' needs a unit");
  EXPECT_INPUT_ERROR(file.at("a").number(Unit::none, at_least(2)), "it must be at least 2");
  // As it can be written: '1e+05' is not a whole number.
  EXPECT_INPUT_ERROR(file.at("a").whole_number(between(1e5, 1e6)),
                     "it must be at least 100000 and at most 1000000");
  EXPECT_EQ(file.find("b"), nullptr);
}

TEST(ConfigNode, FlowTextReadsBackAsTheSameTree) {
  const std::string text = read("- {a: 'x, y', b: [1 cm, '', \"#\"]}\n- plain\n").flow_text();
  EXPECT_EQ(text, R"([{a: "x, y", b: [1 cm, "", "#"]}, plain])");
  EXPECT_EQ(read(text).flow_text(), text);
}

TEST(ConfigNode, KeepsTheOrderOfTheFile) {
  EXPECT_EQ(read("b: 1\na: 2\nc: 3").keys(), (std::vector<std::string>{"b", "a", "c"}));
}

TEST(YamlReader, AFileOfCommentsIsEmpty) {
  EXPECT_TRUE(read("").keys().empty());
  EXPECT_TRUE(read("# nothing differs\n").keys().empty());
}

TEST(YamlReader, RefusesWhatWouldBeSilentlyLost) {
  EXPECT_INPUT_ERROR(read("a: 1\nb: 2\na: 3"), "x.yaml:3: key 'a' comes twice");
  EXPECT_INPUT_ERROR(read("a:\n  b: {c: 1, c: 2}"), "x.yaml:2: key 'c' comes twice");
  EXPECT_INPUT_ERROR(read("a: 1\nb:\n"), "x.yaml:2: key 'b' has no value");
  EXPECT_INPUT_ERROR(read("a: ~"), "key 'a' has no value");
  EXPECT_INPUT_ERROR(read("[1, , 2]"), "x.yaml:1");
  EXPECT_INPUT_ERROR(read("a: 1\n---\nb: 2"), "more than one YAML document");
  EXPECT_INPUT_ERROR(read("a: !!int 3"), "the tag 'tag:yaml.org,2002:int' is not read here");
  EXPECT_INPUT_ERROR(read("{[1]: 2}"), "a list or a map stands where a key should be");
  EXPECT_INPUT_ERROR(read("a: 1\nb: {c: [}"), "x.yaml:2: this is not valid YAML");
}

TEST(YamlReader, RefusesAnchorsSoThatAFewLinesCannotBeABillionValues) {
  std::string bomb = "a: &a [x, x, x, x, x, x, x, x, x]\n";
  for (char last = 'a'; last < 'j'; ++last) {
    const auto name = static_cast<char>(last + 1);
    bomb.append({name, ':', ' ', '&', name, ' ', '[', '*', last, ',', '*', last, ']', '\n'});
  }
  EXPECT_INPUT_ERROR(read(bomb), "x.yaml:1: anchors and aliases (&name, *name) are not read here");
  EXPECT_INPUT_ERROR(read("a: *b"), "x.yaml:1");
}

TEST(YamlReader, RefusesAHundredThousandBrackets) {
  EXPECT_INPUT_ERROR(read(std::string(100'000, '[')), "x.yaml:1");
  EXPECT_INPUT_ERROR(read(std::string(100'000, '{')), "x.yaml:1");
  EXPECT_INPUT_ERROR(read(std::string(40, '[').append(40, ']')), "nested more than 32");
  std::string dashes, maps;
  for (int i = 0; i < 50'000; ++i) dashes += "- ";
  for (std::size_t i = 0; i < 300; ++i) maps.append(i, ' ').append("a:\n");
  EXPECT_INPUT_ERROR(read(dashes), "x.yaml:1");
  EXPECT_INPUT_ERROR(read(maps), "nested more than 32");
}

TEST(YamlReader, RefusesWhatIsNoText) {
  EXPECT_INPUT_ERROR(read(std::string("a: 1\n\0 b", 8)), "x.yaml:2: this is not text");
  EXPECT_INPUT_ERROR(read("a: \xff\xfe"), "this is not text (byte 255)");
  EXPECT_INPUT_ERROR(read("a: \xc0\x80"), "this is not text");  // overlong
  EXPECT_INPUT_ERROR(read(std::string(kLargestYaml + 1, ' ')), "is larger than 8 MB");
  EXPECT_EQ(read("a: Gänge").at("a").text(), "Gänge");
}

}  // namespace
}  // namespace mapbed
