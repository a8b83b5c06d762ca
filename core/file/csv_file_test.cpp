#include "core/file/csv_file.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

TEST(CsvFile, ReadsBackWhatItWrote) {
  const std::vector<CsvRow> rows{{"name", "text"},      {"plain", "two words"},
                                 {"comma", "a, b"},     {"quote", "the \"left\" one"},
                                 {"lines", "one\ntwo"}, {"return", "one\rtwo"},
                                 {"empty", ""}};
  EXPECT_EQ(parse_csv("x.csv", csv_text(rows)), rows);
}

TEST(CsvFile, NumbersComeBackExactly) {
  for (const double value : {0.1, 1.0 / 3.0, -2.5e-300, 12345678.9, 0.0}) {
    EXPECT_EQ(parse_csv_number(csv_number(value)), value);
  }
  EXPECT_EQ(csv_number(std::numeric_limits<double>::quiet_NaN()), "");
  EXPECT_TRUE(std::isnan(parse_csv_number("")));
  EXPECT_TRUE(std::isnan(parse_csv_number("1.5x")));
}

TEST(CsvFile, NamesTheLineThatIsWrong) {
  EXPECT_INPUT_ERROR(parse_csv("x.csv", "a,b\n1,2\n3\n"), "x.csv:3: 1 fields");
  EXPECT_INPUT_ERROR(parse_csv("x.csv", "a,b\n1,\"2\n"), "x.csv:2: a quote is never closed");
}

}  // namespace
}  // namespace mapbed
