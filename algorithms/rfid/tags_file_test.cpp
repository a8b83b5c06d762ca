#include "algorithms/rfid/tags_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/input_error.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

TEST(TagsFile, IsReadAsItIsWritten) {
  const std::vector<TagBelief> tags{{"door", {{1.25, -3.0}}, {1.0}},
                                    {"E2801160", {{0.1, 0.2}, {0.5, 0.75}}, {0.25, 0.75}}};
  const std::vector<TagBelief> read = parse_tags("tags.csv", tags_text(tags));
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].tag, "door");
  EXPECT_EQ(read[0].positions, tags[0].positions);
  EXPECT_EQ(read[1].positions, tags[1].positions);
  EXPECT_EQ(read[1].weights, tags[1].weights);
}

TEST(TagsFile, PositionsThatNobodyBelievesInAreNotWritten) {
  const std::string text = tags_text({{"a", {{1.0, 1.0}, {2.0, 2.0}}, {1.0, 1e-9}}});
  EXPECT_EQ(parse_tags("t", text).at(0).positions.size(), 1u);
}

TEST(TagsFile, KnownPlacesNeedNoWeights) {
  const auto tags = parse_tags("t", "tag,x,y\na,1,2\nb,3,4\n");
  ASSERT_EQ(tags.size(), 2u);
  EXPECT_EQ(tags[1].positions[0], Eigen::Vector2d(3.0, 4.0));
  EXPECT_EQ(tags[1].weights, std::vector<double>{1.0});
}

std::string message_of(const std::string& text) {
  try {
    (void)parse_tags("t.csv", text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing";
}

TEST(TagsFile, WhatIsWrongIsToldWithItsLine) {
  using ::testing::HasSubstr;
  EXPECT_THAT(message_of(""), HasSubstr("tag,x,y,weight"));
  EXPECT_THAT(message_of("x,y,tag\n1,2,a\n"), HasSubstr("t.csv:1"));
  EXPECT_THAT(message_of("tag,x,y\na,1,2\nb,3,4\na,5,6\n"),
              HasSubstr("t.csv:4: tag 'a' comes a second"));
  EXPECT_THAT(message_of("tag,x,y\na,1,2\na,5,6\n"), HasSubstr("t.csv:3: tag 'a' has two places"));
  EXPECT_THAT(message_of("tag,x,y\na,1,\n"), HasSubstr("t.csv:2: tag 'a' has no position"));
  EXPECT_THAT(message_of("tag,x,y\na,inf,0\n"), HasSubstr("t.csv:2: tag 'a' has no position"));
  EXPECT_THAT(message_of("tag,x,y,weight\na,1,2,-1\n"), HasSubstr("t.csv:2"));
  EXPECT_THAT(message_of("tag,x,y,weight\na,1,2,0\n"), HasSubstr("weights of tag 'a' are 0"));
  EXPECT_THAT(message_of("tag,x,y\n,1,2\n"), HasSubstr("t.csv:2: a tag without a name"));
  EXPECT_THAT(message_of("tag,x,y\n"), HasSubstr("has no tags"));
}

}  // namespace
}  // namespace mapbed
