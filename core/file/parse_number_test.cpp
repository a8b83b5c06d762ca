#include "core/file/parse_number.h"

#include <bit>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/random.h"

namespace mapbed {
namespace {

void expect_the_bits_of_from_chars(const std::string& text) {
  double expected = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), expected);
  double value = 0.0;
  const char* const rest = read_number(text.data(), text.data() + text.size(), value);
  ASSERT_EQ(rest, error == std::errc() ? end : nullptr) << text;
  if (rest == nullptr) return;
  ASSERT_EQ(std::bit_cast<std::uint64_t>(value), std::bit_cast<std::uint64_t>(expected)) << text;
}

TEST(ReadNumber, HasTheBitsOfFromCharsForDecimalsOfAllLengths) {
  Rng rng(1);
  for (int i = 0; i < 100'000; ++i) {
    std::string text = rng.index(2) == 0 ? "-" : "";
    for (auto digits = rng.index(14); digits > 0; --digits)
      text += static_cast<char>('0' + rng.index(10));
    if (rng.index(4) != 0) text += '.';
    for (auto digits = rng.index(14); digits > 0; --digits)
      text += static_cast<char>('0' + rng.index(10));
    expect_the_bits_of_from_chars(text);
  }
}

TEST(ReadNumber, HasTheBitsOfFromCharsForAnyDouble) {
  Rng rng(2);
  for (int i = 0; i < 20'000; ++i)
    expect_the_bits_of_from_chars(fmt::format("{}", std::bit_cast<double>(rng.bits())));
}

TEST(ReadNumber, AgreesWithFromCharsOnOddities) {
  for (const char* text : {"",
                           "-",
                           ".",
                           "-.",
                           "5.",
                           ".5",
                           "-0",
                           "-0.0",
                           "1e5",
                           "1.5E-3",
                           "1e",
                           "inf",
                           "nan",
                           "-inf",
                           "0x10",
                           "1,5",
                           "1.2.3",
                           "12abc",
                           "+1",
                           "1e999",
                           "--1",
                           "999999999999999",
                           "9999999999999999",
                           "0.000000000000000000000001"})
    expect_the_bits_of_from_chars(text);
}

TEST(ParseNumber, TakesFiniteNumbersOnly) {
  double number = 0.0;
  EXPECT_TRUE(parse_number("-1.5e3", number));
  EXPECT_EQ(number, -1500.0);
  for (const char* word : {"", "nan", "inf", "1.0x", "one", "1e999"}) {
    EXPECT_FALSE(parse_number(word, number)) << word;
  }
}

}  // namespace
}  // namespace mapbed
