#include "bench/results/claim.h"

#include <gmock/gmock.h>

#include "bench/results/claim_check.h"
#include "bench/results/judge.h"
#include "bench/results/summary.h"

namespace mapbed {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// Variants a and b, levels 1, 2 and 3 of an axis x, seeds as many as values.
Results results_of(const std::vector<std::vector<double>>& a,
                   const std::vector<std::vector<double>>& b) {
  Results results;
  results.axes = {{"x", {"1", "2", "3"}, {1, 2, 3}, ""}};
  results.levels = {{{0}}, {{1}}, {{2}}};
  results.variants = {"a", "b"};
  results.metrics = {{"error", Unit::meter, ""}};
  for (std::size_t level = 0; level < 3; ++level) {
    for (std::size_t seed = 0; seed < a[level].size(); ++seed) {
      for (int variant = 0; variant < 2; ++variant) {
        RunRow row{.level = static_cast<int>(level), .variant = variant, .seed = seed};
        row.values = {variant == 0 ? a[level][seed] : b[level][seed]};
        results.runs.push_back(row);
      }
    }
  }
  results.summary = summary_of(results);
  return results;
}

Verdict judged(const std::string& yaml, const Results& results) {
  const Claim claim = claim_of(parse_config(yaml, {"x.yaml", 1}));
  check_claim(claim, results);
  return judge(claim, results);
}

TEST(Claim, HoldsWhereItDoesAtEveryLevel) {
  const Results results = results_of({{1, 2}, {1, 1}, {2, 2}}, {{3, 3}, {2, 2}, {2, 2}});
  EXPECT_TRUE(judged("{metric: error, of: a, at_most: b}", results).held);
  EXPECT_FALSE(judged("{metric: error, of: a, below: b}", results).held);
  EXPECT_TRUE(judged("{metric: error, of: a, below: b, at: {x: 1}}", results).held);
  EXPECT_FALSE(judged("{metric: error, of: a, at_most: b, times: 0.6}", results).held);
  EXPECT_TRUE(judged("{metric: error, of: a, at_most: 2 m}", results).held);
  EXPECT_FALSE(judged("{metric: error, of: a, at_most: 199 cm, statistic: max}", results).held);
}

TEST(Claim, TellsTheWorstLevel) {
  const Results results = results_of({{1}, {2}, {5}}, {{2}, {3}, {4}});
  const Verdict result = judged("{metric: error, of: a, at_most: b}", results);
  EXPECT_EQ(result.measured, "worst at x = 3: 5 m against 4 m; 2 of 3 hold");
  EXPECT_EQ(result.claim, "error of 'a' is at most that of 'b', at every level");
}

TEST(Claim, ARunWithoutAValueSpeaksAgainstIt) {
  const Results results = results_of({{1, kNone}, {1, 1}, {1, 1}}, {{2, 2}, {2, 2}, {2, 2}});
  const Verdict result = judged("{metric: error, of: a, at_most: 9 m}", results);
  EXPECT_FALSE(result.held);
  EXPECT_THAT(result.measured, ::testing::HasSubstr("1 runs without a value"));
}

TEST(Claim, ATotalIsTheSumOfTheValuesThatThereAre) {
  const Results results = results_of({{1, 2}, {0, 4}, {3, kNone}}, {{1, 1}, {1, 1}, {1, 1}});
  const auto total_at = [&](const std::string& level, const std::string& bound) {
    return judged(
        "{metric: error, of: a, statistic: total, at_most: " + bound + ", at: {x: " + level + "}}",
        results);
  };
  EXPECT_TRUE(total_at("1", "3 m").held);
  EXPECT_FALSE(total_at("2", "3.9 m").held);
  EXPECT_EQ(total_at("3", "9 m").measured, "3 m against 9 m (1 runs without a value)");
}

TEST(Claim, IsNotJudgedWhereTheQuickRunHasNoSuchLevel) {
  Results results = results_of({{1}, {1}, {1}}, {{2}, {2}, {2}});
  results.quick = true;
  const Verdict result = judged("{metric: error, below: 9 m, at: {x: 7}}", results);
  EXPECT_FALSE(result.judged);
  EXPECT_FALSE(result.held);
}

TEST(Claim, IsNotJudgedWhereTheQuickRunIsTooShortForAValue) {
  Results results = results_of({{1}, {1}, {kNone}}, {{2}, {2}, {2}});
  EXPECT_TRUE(judged("{metric: error, of: a, below: 9 m}", results).judged);
  results.quick = true;
  const Verdict result = judged("{metric: error, of: a, below: b}", results);
  EXPECT_FALSE(result.judged);
  EXPECT_FALSE(result.held);
  EXPECT_THAT(result.measured, ::testing::HasSubstr("2 of 3 hold, 1 without a value"));
  // Where it fails, it does so whatever the rest would say.
  const Verdict fails = judged("{metric: error, of: a, above: b}", results);
  EXPECT_TRUE(fails.judged);
  EXPECT_FALSE(fails.held);
}

TEST(Claim, IsNotJudgedByAQuickRunThatIsTooSmallWhateverItGives) {
  Results results = results_of({{1}, {1}, {1}}, {{2}, {2}, {2}});
  results.quick = true;
  EXPECT_TRUE(judged("{metric: error, of: a, below: b}", results).held);
  results.judges = false;
  for (const std::string relation : {"below", "above"}) {
    const Verdict result = judged("{metric: error, of: a, " + relation + ": b}", results);
    EXPECT_FALSE(result.judged) << relation;
    EXPECT_FALSE(result.held) << relation;
    EXPECT_THAT(result.measured, ::testing::HasSubstr("1 m against 2 m"));
  }
}

TEST(Claim, AFailedRunCountsInAQuickRunToo) {
  Results results = results_of({{1}, {1}, {kNone}}, {{2}, {2}, {2}});
  results.quick = true;
  results.runs[4].failure = "no match";  // of a, at the third level
  results.summary = summary_of(results);
  const Verdict result = judged("{metric: error, of: a, below: b}", results);
  EXPECT_TRUE(result.judged);
  EXPECT_FALSE(result.held);
}

TEST(Claim, SkippedRunsSayNothing) {
  Results results = results_of({{1}, {1}, {}}, {{2}, {2}, {}});
  const Verdict result = judged("{metric: error, of: a, below: b, test: sign}", results);
  EXPECT_FALSE(result.judged);
  EXPECT_FALSE(judged("{metric: error, of: a, above: b, at: {x: 1}}", results).held);
  EXPECT_TRUE(judged("{metric: error, of: a, below: b, at: {x: 1}}", results).held);
}

TEST(Claim, TheUpperHalfBeginsInTheMiddle) {
  const Results results = results_of({{9}, {1}, {1}}, {{2}, {2}, {2}});
  EXPECT_TRUE(judged("{metric: error, of: a, below: b, at: upper half}", results).held);
  const Results middle = results_of({{1}, {9}, {1}}, {{2}, {2}, {2}});
  EXPECT_FALSE(judged("{metric: error, of: a, below: b, at: upper half}", middle).held);
}

TEST(Claim, ASignTestNeedsEnoughPairs) {
  const std::vector<double> low(6, 1.0);
  const std::vector<double> high(6, 2.0);
  EXPECT_TRUE(judged("{metric: error, of: a, below: b, test: sign}",
                     results_of({low, low, low}, {high, high, high}))
                  .held);
}

// 3 m against 2 m, where up to twice as much will do.
TEST(Claim, ASignTestComparesWithAsManyTimesTheOther) {
  const std::vector<double> own(6, 3.0);
  const std::vector<double> other(6, 2.0);
  const Results results = results_of({own, own, own}, {other, other, other});
  EXPECT_TRUE(judged("{metric: error, of: a, below: b, times: 2, test: sign}", results).held);
  EXPECT_FALSE(judged("{metric: error, of: a, below: b, times: 1.4, test: sign}", results).held);
}

// All of four pairs are one way by chance in one of 16 cases, all of five in one of 32.
TEST(Claim, ASignTestOfFewerThanFivePairsIsNotJudged) {
  const auto at_first_level = [](const std::vector<double>& a, const std::vector<double>& b,
                                 const std::string& relation) {
    return judged("{metric: error, of: a, " + relation + ": b, test: sign, at: {x: 1}}",
                  results_of({a, {1}, {1}}, {b, {1}, {1}}));
  };
  const std::vector<double> four(4, 1.0);
  const std::vector<double> more(4, 2.0);
  for (const std::string relation : {"below", "above"}) {
    const Verdict few = at_first_level(four, more, relation);
    EXPECT_FALSE(few.judged) << relation;
    EXPECT_FALSE(few.held) << relation;
    EXPECT_THAT(few.measured, ::testing::HasSubstr("p = "));
    EXPECT_THAT(few.measured, ::testing::HasSubstr("4 are too few"));
  }
  EXPECT_TRUE(at_first_level({1, 1, 1, 1, 1}, {2, 2, 2, 2, 2}, "below").held);
  // Five that could have told, and do not: two are equal.
  const Verdict equal = at_first_level({1, 1, 1, 2, 2}, {2, 2, 2, 2, 2}, "below");
  EXPECT_TRUE(equal.judged);
  EXPECT_FALSE(equal.held);
}

// In the order in which they are written.
TEST(Claim, IsWrittenAsItIsRead) {
  for (
      const std::string yaml :
      {"{metric: error, at_most: 2 m}",
       "{metric: error, of: \"a, b\", statistic: max, below: \"c: d\", times: 0.1, at: upper half}",
       "{metric: error, equals: 0.7, within: 1e-9, at: {a.x: 70, y: \"b, c\"}, thesis: \"so: so\"}",
       "{metric: error, of: a, above: b, against_metric: turn, test: sign}",
       "{series: error, take: first, at_least: 1 m}",
       "{series: error, at_least: 1 m, at: {time: 10 s}}"}) {
    EXPECT_EQ(claim_text(claim_of(parse_config(yaml, {"x.yaml", 1}))), yaml);
  }
}

}  // namespace
}  // namespace mapbed
