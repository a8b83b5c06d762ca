#include "core/config/suggestion.h"

#include <gtest/gtest.h>

namespace mapbed {
namespace {

TEST(Suggestion, CountsInsertionsDeletionsReplacementsAndSwaps) {
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
  EXPECT_EQ(edit_distance("sigma", "simga"), 1u);  // one swap
  EXPECT_EQ(edit_distance("Sigma", "sigma"), 0u);
  EXPECT_EQ(edit_distance("ca", "abc"), 3u);  // no letter is touched twice
}

TEST(Suggestion, FindsTheWordThatWasMeant) {
  const std::vector<std::string> known = {"translation_sigma", "rotation_sigma", "rate"};
  EXPECT_EQ(nearest("rotaton_sigma", known), "rotation_sigma");
  EXPECT_EQ(nearest("raet", known), "rate");
}

TEST(Suggestion, IsSilentWhereNothingIsNear) {
  EXPECT_EQ(nearest("speed", {"rotation_sigma", "rate"}), "");
  EXPECT_EQ(nearest("a", {"b"}), "");  // every letter wrong
  EXPECT_EQ(nearest("rate", {}), "");
  EXPECT_EQ(nearest(std::string(1'000'000, 'x'), {"x"}), "");
}

TEST(Suggestion, NamesWhatThereIsWhereNothingIsNear) {
  EXPECT_EQ(suggestion("raet", {"rate", "size"}), "did you mean 'rate'?");
  EXPECT_EQ(suggestion("speed", {"rate", "size"}), "known are: rate, size");
}

}  // namespace
}  // namespace mapbed
