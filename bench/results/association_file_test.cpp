#include "bench/results/association_file.h"

#include <limits>

#include <gmock/gmock.h>

#include "bench/results/testing/example_associations.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

AssociationTree read_again(const AssociationTree& tree) {
  return parse_associations("a.json", associations_json(tree));
}

// The example's text with one place of it changed.
std::string changed(const std::string& from, const std::string& to) {
  std::string text = associations_json(example_associations());
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(AssociationFile, WhatIsReadAgainIsTheSame) {
  const AssociationTree tree = example_associations();
  const AssociationTree read = read_again(tree);
  EXPECT_EQ(read.local_maps, tree.local_maps);
  ASSERT_EQ(read.nodes.size(), 7u);
  EXPECT_EQ(read.nodes[0].parent, -1);
  EXPECT_EQ(read.nodes[4].parent, 2);
  EXPECT_EQ(read.nodes[4].local_map, 3);
  EXPECT_EQ(read.nodes[4].associated, 0);
  EXPECT_EQ(read.nodes[6].log_likelihood, -51.125);
  EXPECT_TRUE(read.nodes[4].expanded);
  EXPECT_FALSE(read.nodes[6].expanded);
  ASSERT_EQ(read.choices.size(), 5u);
  EXPECT_EQ(read.choices[4].node, 6u);
  EXPECT_EQ(read.choices[4].newest, -9.125);
  ASSERT_EQ(read.revisions.size(), 1u);
  EXPECT_EQ(read.revisions[0].since, 3);
  EXPECT_EQ(read.revisions[0].log_likelihood_before, -90.0);
  EXPECT_EQ(read.chosen, 6u);
  EXPECT_EQ(associations_json(read), associations_json(tree));
}

TEST(AssociationFile, OfNothingIsOneToo) {
  const AssociationTree read = read_again({});
  EXPECT_TRUE(read.nodes.empty());
  EXPECT_TRUE(read.revisions.empty());
}

TEST(AssociationFile, AnImpossibleDecisionStaysOne) {
  AssociationTree tree = example_associations();
  tree.nodes[5].log_likelihood = -std::numeric_limits<double>::infinity();
  EXPECT_THAT(associations_json(tree), HasSubstr("\"log_likelihood\":null"));
  EXPECT_EQ(read_again(tree).nodes[5].log_likelihood, tree.nodes[5].log_likelihood);
}

TEST(AssociationFile, TellsOfARevisionWhichDecisionsChanged) {
  const AssociationTree tree = example_associations();
  EXPECT_THAT(path_to(tree, 6), ElementsAre(0, 1, 2, 4, 6));
  EXPECT_THAT(changed_decisions(tree, tree.revisions[0]),
              ElementsAre(ChangedDecision{3, -1, 0}, ChangedDecision{4, -1, 1}));
  EXPECT_THAT(associations_json(tree), HasSubstr("{\"local_map\":4,\"before\":-1,\"after\":1}"));
}

TEST(AssociationFile, RefusesWhatIsNone) {
  const auto parsed = [](const std::string& text) { return parse_associations("a.json", text); };
  EXPECT_INPUT_ERROR(parsed("{\"local_maps\": ["), "a.json: is not JSON, or was cut short");
  EXPECT_INPUT_ERROR(parsed("[]"), "a.json: is not an object");
  EXPECT_INPUT_ERROR(parsed("{}"), "has no 'local_maps'");
  EXPECT_INPUT_ERROR(parsed(changed("[0.0,5.0]", "[0.0]")), "not a list of pairs of times");
  EXPECT_INPUT_ERROR(parsed(changed("\"parent\":1", "\"parent\":2")),
                     "nodes[2]: 'parent' is 2, there is none of that number here");
  EXPECT_INPUT_ERROR(parsed(changed("\"local_map\":2", "\"local_map\":1")),
                     "nodes[2]: is about no later local map than its parent");
  EXPECT_INPUT_ERROR(parsed(changed("\"local_map\":2", "\"local_map\":7")), "'local_map' is 7");
  EXPECT_INPUT_ERROR(parsed(changed("\"associated\":0", "\"associated\":3")), "'associated' is 3");
  EXPECT_INPUT_ERROR(parsed(changed("\"log_likelihood\":-20.0", "\"log_likelihood\":\"no\"")),
                     "nodes[1]: 'log_likelihood' is not a number");
  EXPECT_INPUT_ERROR(parsed(changed("\"node\":3", "\"node\":0.5")),
                     "choices[3]: 'node' is not a whole number");
  EXPECT_INPUT_ERROR(parsed(changed("\"expanded\":true", "\"expanded\":1")),
                     "'expanded' is neither true nor false");
  EXPECT_INPUT_ERROR(parsed(changed("\"chosen\": 6", "\"chosen\": 7")), "'chosen' is 7");
}

}  // namespace
}  // namespace mapbed
