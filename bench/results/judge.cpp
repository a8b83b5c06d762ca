#include "bench/results/judge.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "bench/results/cost_claims.h"
#include "bench/results/series_claims.h"
#include "bench/results/summary.h"
#include "core/check.h"
#include "core/config/quantity.h"
#include "core/statistics/sign_test.h"

namespace mapbed {
namespace {

constexpr double kSignificance = 0.05;

double value_of(const SummaryRow& row, Claim::Statistic statistic) {
  switch (statistic) {
    case Claim::Statistic::mean:
      return row.mean;
    case Claim::Statistic::median:
      return row.median;
    case Claim::Statistic::min:
      return row.min;
    case Claim::Statistic::max:
      return row.max;
    case Claim::Statistic::total:
      return row.mean * (row.runs - row.missing);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

const SummaryRow& summary_row(const Results& results, int level, int variant, int metric) {
  const auto found =
      std::find_if(results.summary.begin(), results.summary.end(), [&](const SummaryRow& row) {
        return row.level == level && row.variant == variant && row.metric == metric;
      });
  CHECK(found != results.summary.end());
  return *found;
}

bool is_at(const Claim& claim, const Results& results, const Level& level) {
  for (const auto& [path, value] : claim.at) {
    const auto axis = static_cast<std::size_t>(axis_index(results, path));
    const auto choice = static_cast<std::size_t>(level.choice[axis]);
    if (results.axes[axis].texts[choice] != value) return false;
  }
  return true;
}

std::vector<int> levels_of(const Claim& claim, const Results& results) {
  std::vector<int> levels;
  for (std::size_t i = 0; i < results.levels.size(); ++i) {
    const Level& level = results.levels[i];
    if (claim.where == Claim::Where::upper_half && !level.choice.empty()) {
      const std::size_t count = results.axes.front().texts.size();
      if (2 * static_cast<std::size_t>(level.choice.front()) + 1 < count) continue;
    }
    if (is_at(claim, results, level)) levels.push_back(static_cast<int>(i));
  }
  return levels;
}

std::vector<int> variants_of(const Claim& claim, const Results& results) {
  if (!claim.of.empty()) return {variant_index(results, claim.of)};
  std::vector<int> all;
  for (std::size_t i = 0; i < results.variants.size(); ++i) all.push_back(static_cast<int>(i));
  return all;
}

// How far a value is on the right side; negative: on the wrong one.
double margin(Claim::Relation relation, double value, double bound, double within) {
  switch (relation) {
    case Claim::Relation::at_most:
    case Claim::Relation::below:
      return bound - value;
    case Claim::Relation::at_least:
    case Claim::Relation::above:
      return value - bound;
    case Claim::Relation::equals:
      return within - std::abs(value - bound);
  }
  return -1.0;
}

bool is_strict(Claim::Relation relation) {
  return relation == Claim::Relation::below || relation == Claim::Relation::above;
}

// In the order of what is worth telling.
enum class Outcome : int { fails, not_judged, holds };

// One comparison: a variant at a level.
struct Comparison {
  int level = 0;
  int variant = 0;
  double value = 0.0;
  double bound = 0.0;
  double margin = 0.0;
  int missing = 0;
  Outcome outcome = Outcome::fails;
};

int count_of(const std::vector<Comparison>& all, Outcome outcome) {
  return static_cast<int>(std::count_if(all.begin(), all.end(),
                                        [&](const Comparison& c) { return c.outcome == outcome; }));
}

class Judge {
 public:
  Judge(const Claim& claim, const Results& results)
      : claim_(claim),
        results_(results),
        metric_(metric_index(results, claim.metric)),
        other_(variant_index(results, claim.against)),
        unit_(results.metrics[static_cast<std::size_t>(metric_)].unit) {
    other_metric_ =
        claim.against_metric.empty() ? metric_ : metric_index(results, claim.against_metric);
    if (other_ < 0) number_ = parse_quantity(claim.against, unit_, claim.place);
    if (!claim.within.empty()) within_ = parse_quantity(claim.within, unit_, claim.place);
  }

  Verdict verdict() const {
    Verdict result{.claim = {}, .thesis = claim_.thesis};
    std::vector<Comparison> all;
    for (const int level : levels_of(claim_, results_)) {
      for (const int variant : variants_of(claim_, results_))
        all.push_back(compare(level, variant));
    }
    if (all.empty()) {
      result.judged = false;
      result.measured = "this run has no such level";
      return result;
    }
    const bool fails = count_of(all, Outcome::fails) > 0;
    result.judged = results_.judges && (fails || count_of(all, Outcome::not_judged) == 0);
    result.held = result.judged && !fails;
    result.measured = figures_of(all);
    if (claim_.sign_test && result.judged) add_sign_test(result);
    return result;
  }

 private:
  Comparison compare(int level, int variant) const {
    const SummaryRow& row = summary_row(results_, level, variant, metric_);
    Comparison c{.level = level, .variant = variant, .missing = row.missing};
    c.value = value_of(row, claim_.statistic);
    c.bound = number_;
    bool judged = can_be_judged(row);
    if (other_ >= 0) {
      const SummaryRow& other = summary_row(results_, level, other_, other_metric_);
      c.bound = value_of(other, claim_.statistic);
      c.missing += other.missing;
      judged = judged && can_be_judged(other);
    }
    c.bound *= claim_.times;
    c.margin = margin(claim_.relation, c.value, c.bound, within_);
    const bool enough = is_strict(claim_.relation) ? c.margin > 0.0 : c.margin >= 0.0;
    if (!judged) {
      c.outcome = Outcome::not_judged;
    } else {
      c.outcome = enough && c.missing == 0 ? Outcome::holds : Outcome::fails;  // NaN: not enough
    }
    return c;
  }

  // Runs that were skipped say nothing, and a reduced run may be too short for a value. A run that
  // failed counts all the same.
  bool can_be_judged(const SummaryRow& row) const {
    if (row.runs == 0) return false;
    return !results_.quick || row.missing <= row.failed;
  }

  std::string figure(double value) const {
    if (std::isnan(value)) return "no value";
    const std::string symbol = unit_symbol(unit_);
    return fmt::format("{:.4g}{}{}", value, symbol.empty() ? "" : " ", symbol);
  }

  // The comparison that is nearest to failing, and how many failed.
  std::string figures_of(const std::vector<Comparison>& all) const {
    const auto worst =
        std::min_element(all.begin(), all.end(), [](const Comparison& a, const Comparison& b) {
          if (a.outcome != b.outcome) return a.outcome < b.outcome;
          return a.margin < b.margin;
        });
    std::string text = figure(worst->value) + " against " + figure(worst->bound);
    if (worst->missing > 0) text += fmt::format(" ({} runs without a value)", worst->missing);
    if (all.size() == 1) return text;
    std::string where = results_.axes.empty() ? "" : level_text(results_, worst->level);
    if (claim_.of.empty() && results_.variants.size() > 1) {
      where +=
          (where.empty() ? "" : ", ") + results_.variants[static_cast<std::size_t>(worst->variant)];
    }
    text = fmt::format("worst at {}: {}; {} of {} hold", where, text, count_of(all, Outcome::holds),
                       all.size());
    const int not_judged = count_of(all, Outcome::not_judged);
    if (not_judged > 0) text += fmt::format(", {} without a value", not_judged);
    return text;
  }

  void add_sign_test(Verdict& result) const {
    const std::vector<int> levels = levels_of(claim_, results_);
    const int own = variant_index(results_, claim_.of);
    int pairs = 0;
    int wins = 0;
    int losses = 0;
    for (const RunRow& run : results_.runs) {
      if (run.variant != own) continue;
      if (std::find(levels.begin(), levels.end(), run.level) == levels.end()) continue;
      const auto pair =
          std::find_if(results_.runs.begin(), results_.runs.end(), [&](const RunRow& other) {
            return other.variant == other_ && other.level == run.level && other.seed == run.seed;
          });
      CHECK(pair != results_.runs.end());  // skipped runs are not judged
      const double difference =
          margin(claim_.relation, run.values[static_cast<std::size_t>(metric_)],
                 pair->values[static_cast<std::size_t>(other_metric_)] * claim_.times, 0.0);
      ++pairs;
      if (difference > 0.0) ++wins;
      if (difference < 0.0) ++losses;
    }
    const double p = sign_test_probability(wins, losses);
    result.judged = sign_test_probability(pairs, 0) < kSignificance;  // equal pairs count here
    result.held = result.held && result.judged && p < kSignificance;
    result.measured +=
        fmt::format("; sign test: {} pairs for it, {} against, p = {:.3g}", wins, losses, p);
    if (!result.judged) result.measured += fmt::format(", {} are too few", pairs);
  }

  const Claim& claim_;
  const Results& results_;
  int metric_;
  int other_;  // -1: a number
  int other_metric_ = 0;
  Unit unit_;
  double number_ = 0.0;
  double within_ = 0.0;
};

}  // namespace

Verdict judge(const Claim& claim, const Results& results) {
  const std::string sentence = sentence_of(claim, results);
  const auto on = [&](const Claim& of_metric, const Results& measured) {
    Verdict verdict = Judge(of_metric, measured).verdict();
    verdict.claim = sentence;
    return verdict;
  };
  if (claim.is_series) {
    return on(as_metric_claim(claim, results), with_series_as_metrics(results, claim));
  }
  if (!is_about_cost(claim)) return on(claim, results);
  Verdict verdict = on(claim, with_costs_as_metrics(results));
  verdict.of_cost = true;
  return verdict;
}

std::vector<Verdict> judge_all(const Results& results) {
  std::vector<Verdict> verdicts;
  for (const Claim& claim : results.claims) verdicts.push_back(judge(claim, results));
  std::stable_partition(verdicts.begin(), verdicts.end(),
                        [](const Verdict& verdict) { return !verdict.of_cost; });
  return verdicts;
}

bool judge_again(Results& results) {
  if (results.claims.empty()) return false;
  results.summary = summary_of(results);
  results.verdicts = judge_all(results);
  return true;
}

}  // namespace mapbed
