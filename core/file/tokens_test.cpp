#include "core/file/tokens.h"

#include <gtest/gtest.h>

namespace mapbed {
namespace {

TEST(NextLine, TakesBothLineEndsAndTheLastLineWithoutOne) {
  std::string_view text = "a\r\nb\n\nc";
  EXPECT_EQ(next_line(text), "a");
  EXPECT_EQ(next_line(text), "b");
  EXPECT_EQ(next_line(text), "");
  EXPECT_EQ(next_line(text), "c");
  EXPECT_TRUE(text.empty());
}

TEST(NextWord, SkipsBlanksAndTabs) {
  std::string_view line = " a\t bc ";
  EXPECT_EQ(next_word(line), "a");
  EXPECT_EQ(next_word(line), "bc");
  EXPECT_EQ(next_word(line), "");
}

TEST(Tokens, GiveWordsAndNumbersBetweenAnyBlanks) {
  Tokens tokens("  LASER\t2 1.5   -3 \r");
  EXPECT_EQ(tokens.word(), "LASER");
  EXPECT_EQ(tokens.counted_numbers(), (std::vector<double>{1.5, -3.0}));
  EXPECT_TRUE(tokens.ok());
  EXPECT_TRUE(tokens.at_end());
}

TEST(Tokens, AreNotOkAfterAMissingOrGarbledNumber) {
  Tokens missing("1");
  missing.number();
  EXPECT_TRUE(missing.ok());
  missing.number();
  EXPECT_FALSE(missing.ok());
  Tokens garbled("1.5x 2");
  EXPECT_EQ(garbled.number(), 0.0);
  EXPECT_FALSE(garbled.ok());
}

TEST(Tokens, DoNotBelieveACountBeyondTheLine) {
  for (const char* line : {"1000000000 1 2", "-3 1 2", "2.5 1 2", "nan 1", "3 1 2"}) {
    Tokens tokens(line);
    tokens.counted_numbers();
    EXPECT_FALSE(tokens.ok()) << line;
  }
}

}  // namespace
}  // namespace mapbed
