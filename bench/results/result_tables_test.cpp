#include "bench/results/result_tables.h"

#include <limits>

#include <gmock/gmock.h>

namespace mapbed {
namespace {

Results two_runs() {
  Results results;
  results.axes = {{"robot.odometry.rotation_sigma", {"0 deg", "2 deg"}, {0, 2}, "deg"}};
  results.levels = {{{0}}, {{1}}};
  results.variants = {"filter off"};
  results.metrics = {{"translation_error", Unit::meter, ""}, {"success", Unit::none, ""}};
  results.runs = {{.run = 0, .level = 0, .variant = 0, .seed = 7, .values = {0.25, 1.0}},
                  {.run = 1,
                   .level = 1,
                   .variant = 0,
                   .seed = 7,
                   .values = {std::numeric_limits<double>::quiet_NaN(), 0.0},
                   .failure = "lost, at 3 s"}};
  return results;
}

TEST(ResultTables, ARowForEachRunFailedOnesIncluded) {
  EXPECT_EQ(runs_csv(two_runs()),
            "run,seed,level,robot.odometry.rotation_sigma,variant,translation_error,success,"
            "failure\n"
            "0,7,0,0 deg,filter off,0.25,1,\n"
            "1,7,1,2 deg,filter off,,0,\"lost, at 3 s\"\n");
}

TEST(ResultTables, TheSummaryNamesUnits) {
  Results results = two_runs();
  results.summary = {{.level = 1,
                      .variant = 0,
                      .metric = 0,
                      .runs = 3,
                      .failed = 1,
                      .missing = 1,
                      .mean = 2.0,
                      .low = 1.5,
                      .high = 2.5,
                      .median = 2.0,
                      .min = 1.0,
                      .max = 3.0}};
  EXPECT_THAT(
      summary_csv(results),
      ::testing::EndsWith("1,2 deg,filter off,translation_error,m,3,1,1,2,1.5,2.5,2,1,3\n"));
}

TEST(ResultTables, ALevelIsNamedByItsValues) {
  EXPECT_EQ(level_text(two_runs(), 1), "rotation_sigma = 2 deg");
  Results plain;
  plain.levels = {{}};
  EXPECT_EQ(level_text(plain, 0), "all");
}

}  // namespace
}  // namespace mapbed
