#include "bench/results/series_claims.h"

#include <cmath>

#include <gmock/gmock.h>

#include "bench/results/claim_check.h"
#include "bench/results/judge.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

// Two variants, two seeds each, over two levels of people: errors that grow from 0 m by `slope`
// m/s for 10 s; a residual of three iterations.
Results drives() {
  Results r;
  r.axes = {axis_of("people", {"0", "5"})};
  r.levels = levels_of(r.axes);
  r.variants = {"raw", "matched"};
  r.series_metrics = {{"error", Unit::meter, "time", Unit::second, ""},
                      {"residual", Unit::radian, "iteration", Unit::none, ""}};
  for (int run = 0; run < 8; ++run) {
    const int variant = run % 2;
    const double slope = (variant == 0 ? 0.5 : 0.1) * (run / 4 == 0 ? 1.0 : 2.0);
    r.runs.push_back({.run = run,
                      .level = run / 2 % 2,
                      .variant = variant,
                      .seed = static_cast<std::uint64_t>(run / 4)});
    r.series.push_back({"error", {{0.0, 0.0}, {4.0, 4.0 * slope}, {10.0, 10.0 * slope}}, run});
    r.series.push_back({"residual", {{0, 0.4}, {1, 0.2}, {2, 0.1}}, run});
  }
  return r;
}

Verdict judged(const std::string& yaml, const Results& results) {
  const Claim claim = claim_of(parse_config(yaml, {"x.yaml", 1}));
  check_claim(claim, results);
  return judge(claim, results);
}

TEST(SeriesClaims, TakeTheFirstTheLastOrAnyValueBetween) {
  const Results r = drives();
  // The mean slope of the seeds is 0.75 m/s of raw and 0.15 m/s of matched.
  EXPECT_TRUE(judged("{series: error, take: first, equals: 0 m, within: 0 m}", r).held);
  EXPECT_TRUE(
      judged("{series: error, take: last, of: raw, equals: 7.5 m, within: 1e-12 m}", r).held);
  EXPECT_TRUE(judged("{series: error, of: matched, at: {time: 7 s}, equals: 1.05 m, "
                     "within: 1e-12 m}",
                     r)
                  .held);
  EXPECT_TRUE(judged("{series: residual, at: {iteration: 1}, equals: 0.2 rad, "
                     "within: 1e-12 rad}",
                     r)
                  .held);
  EXPECT_FALSE(judged("{series: error, of: raw, at: {time: 7 s}, below: matched}", r).held);
}

TEST(SeriesClaims, KeepToTheLevelsAskedFor) {
  Results r = drives();
  for (Series& series : r.series) {
    if (series.run / 2 % 2 == 1) series.points.back().value = 99.0;  // with five people
  }
  EXPECT_TRUE(judged("{series: error, of: raw, at: {time: 10 s, people: 0}, below: 8 m}", r).held);
  EXPECT_FALSE(judged("{series: error, of: raw, at: {time: 10 s}, below: 8 m}", r).held);
}

TEST(SeriesClaims, AreTestedBySignsToo) {
  const Verdict verdict =
      judged("{series: error, take: last, of: matched, below: raw, test: sign}", drives());
  EXPECT_FALSE(verdict.held) << "four pairs are too few: 1/16";
  EXPECT_THAT(verdict.measured, ::testing::HasSubstr("4 pairs for it, 0 against, p = 0.0625"));
}

TEST(SeriesClaims, AreSaidInASentence) {
  const Results r = drives();
  EXPECT_EQ(judged("{series: error, take: last, of: matched, at_most: raw, times: 0.1}", r).claim,
            "last error of 'matched' is at most 0.1 times that of 'raw', at every level");
  EXPECT_EQ(judged("{series: error, of: matched, at: {time: 7 s}, below: 2 m}", r).claim,
            "error of 'matched' is below 2 m, at time = 7 s");
}

TEST(SeriesClaims, ARunWhoseSeriesEndsBeforeSpeaksAgainstThem) {
  Results r = drives();
  r.series[0].points.pop_back();
  const Verdict verdict = judged("{series: error, of: raw, at: {time: 7 s}, below: 99 m}", r);
  EXPECT_FALSE(verdict.held);
  EXPECT_THAT(verdict.measured, ::testing::HasSubstr("1 runs without a value"));
  EXPECT_TRUE(std::isnan(value_at(r.series[0], r.series_metrics[0], 7.0)));
  EXPECT_TRUE(std::isnan(value_at(r.series[0], r.series_metrics[0], -1.0)));
}

TEST(SeriesClaims, ARunThatEndedItsIterationsStaysWhereItSettled) {
  const SeriesMetric residual{"residual", Unit::radian, "iteration", Unit::none, ""};
  const Series series{"residual", {{0, 4.0}, {1, 2.0}}, 0};
  EXPECT_EQ(value_at(series, residual, 7.0), 2.0);
  EXPECT_TRUE(std::isnan(value_at(series, residual, -1.0)));
  EXPECT_TRUE(std::isnan(value_at({"residual", {}, 0}, residual, 0.0)));
}

TEST(SeriesClaims, AreRefusedWhereTheyDoNotSayWhatTheyTake) {
  const auto refuse = [](const std::string& yaml, const std::string& message) {
    EXPECT_INPUT_ERROR(judged(yaml, drives()), message);
  };
  refuse("{series: error, of: raw, below: 1 m}", "add 'take: first', 'take: last' or 'at: {time");
  refuse("{series: error, take: last, at: {time: 7 s}, below: 1 m}", "takes two values");
  refuse("{series: error, at: {time: 7 m}, below: 1 m}", "'7 m' is not a time");
  refuse("{series: error, take: middle, below: 1 m}", "'middle'");
  refuse("{series: eror, take: last, below: 1 m}", "none of the scenario's series; did you mean");
  refuse("{series: error, take: last, below: 1 s}", "'1 s' is not a length");
  refuse("{series: error, at: {time: 7 s}, of: raw, below: raw, against_metric: residual}",
         "'residual' does not go over time");
}

}  // namespace
}  // namespace mapbed
