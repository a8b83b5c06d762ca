#include "bench/results/cost_claims.h"

#include <gmock/gmock.h>

#include "bench/results/claim_check.h"
#include "bench/results/judge.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

// Two runs of ten recorded seconds each: 4 s and 1 s of the method, 5 s and 2 s in all.
Results two_runs() {
  Results results;
  results.levels = {{}};
  results.variants = {"slow", "quick"};
  results.metrics = {{"failures", Unit::none, ""}};
  results.runs = {{.run = 0, .variant = 0, .values = {0}}, {.run = 1, .variant = 1, .values = {0}}};
  results.costs = {{.run = 0, .seconds = 5.0, .method_seconds = 4.0, .recorded_seconds = 10.0},
                   {.run = 1, .seconds = 2.0, .method_seconds = 1.0, .recorded_seconds = 10.0}};
  return results;
}

Verdict judged(const std::string& yaml) {
  const Claim claim = claim_of(parse_config(yaml, {"x.yaml", 1}));
  EXPECT_TRUE(is_about_cost(claim));
  const Results results = two_runs();
  check_claim(claim, results);
  const Verdict verdict = judge(claim, results);
  EXPECT_TRUE(verdict.of_cost);
  return verdict;
}

TEST(CostClaims, CompareVariantsAndNumbers) {
  EXPECT_TRUE(judged("{metric: method_seconds, of: quick, below: slow}").held);
  EXPECT_TRUE(judged("{metric: real_time_factor, of: slow, equals: 2.5, within: 1e-12}").held);
  EXPECT_FALSE(judged("{metric: run_seconds, of: slow, at_most: 4 s}").held);
  EXPECT_EQ(judged("{metric: real_time_factor, of: quick, above: 1}").measured, "10 against 1");
}

TEST(CostClaims, HaveNoValueWhereAMethodDoesNotTellItsTime) {
  Results results = two_runs();
  for (CostRow& cost : results.costs) cost.method_seconds = 0.0;
  const Results costs = with_costs_as_metrics(results);
  EXPECT_EQ(costs.summary[0].missing, 0);  // run_seconds
  EXPECT_EQ(costs.summary[1].missing, 1);
  EXPECT_EQ(costs.summary[2].missing, 1);
}

TEST(CostClaims, AreNotAboutWhatIsMeasured) {
  EXPECT_FALSE(is_about_cost(claim_of(parse_config("{metric: failures, below: 1}", {"x", 1}))));
}

}  // namespace
}  // namespace mapbed
