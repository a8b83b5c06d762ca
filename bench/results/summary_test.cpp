#include "bench/results/summary.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mapbed {
namespace {

TEST(Summary, CountsFailedRunsAndThoseWithoutValue) {
  Results results;
  results.levels = {{}};
  results.variants = {"all"};
  results.metrics = {{"error", Unit::meter, ""}};
  results.runs = {{.run = 0, .values = {1.0}},
                  {.run = 1, .values = {4.0}, .failure = "too far off"},
                  {.run = 2, .values = {std::nan("")}, .failure = "ended early"},
                  {.run = 3, .values = {4.0}}};
  const std::vector<SummaryRow> rows = summary_of(results);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].runs, 4);
  EXPECT_EQ(rows[0].failed, 2);
  EXPECT_EQ(rows[0].missing, 1);
  EXPECT_DOUBLE_EQ(rows[0].mean, 3.0);
  EXPECT_DOUBLE_EQ(rows[0].median, 4.0);
  EXPECT_DOUBLE_EQ(rows[0].min, 1.0);
  EXPECT_DOUBLE_EQ(rows[0].max, 4.0);
  // Of 27 resamples of 1, 4 and 4 one has the mean 1, eight have 4: more than 2.5 % each.
  EXPECT_DOUBLE_EQ(rows[0].low, 1.0);
  EXPECT_DOUBLE_EQ(rows[0].high, 4.0);
}

}  // namespace
}  // namespace mapbed
