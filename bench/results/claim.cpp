#include "bench/results/claim.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/check.h"
#include "core/config/quantity.h"
#include "core/config/suggestion.h"
#include "core/statistics/sign_test.h"

namespace mapbed {
namespace {

constexpr double kSignificance = 0.05;

const std::vector<std::string> kStatistics{"mean", "median", "min", "max", "total"};
const std::vector<std::string> kRelations{"at_most", "at_least", "below", "above", "equals"};
const std::vector<std::string> kRelationWords{"at most", "at least", "below", "above", "equal to"};

template <class Things, class Name>
int index_of(const Things& things, const std::string& name, Name&& name_of) {
  for (std::size_t i = 0; i < things.size(); ++i) {
    if (name_of(things[i]) == name) return static_cast<int>(i);
  }
  return -1;
}

int metric_index(const Results& results, const std::string& name) {
  return index_of(results.metrics, name, [](const Metric& m) { return m.name; });
}

int variant_index(const Results& results, const std::string& name) {
  return index_of(results.variants, name, [](const std::string& v) { return v; });
}

int axis_index(const Results& results, const std::string& path) {
  return index_of(results.axes, path, [](const SweepAxis& a) { return a.path; });
}

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
enum class Verdict : int { fails, not_judged, holds };

// One comparison: a variant at a level.
struct Comparison {
  int level = 0;
  int variant = 0;
  double value = 0.0;
  double bound = 0.0;
  double margin = 0.0;
  int missing = 0;
  Verdict verdict = Verdict::fails;
};

int count_of(const std::vector<Comparison>& all, Verdict verdict) {
  return static_cast<int>(std::count_if(all.begin(), all.end(),
                                        [&](const Comparison& c) { return c.verdict == verdict; }));
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

  ClaimResult result() const {
    ClaimResult result{.claim = text_of(claim_, results_), .thesis = claim_.thesis};
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
    const bool fails = count_of(all, Verdict::fails) > 0;
    result.judged = fails || count_of(all, Verdict::not_judged) == 0;
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
      c.verdict = Verdict::not_judged;
    } else {
      c.verdict = enough && c.missing == 0 ? Verdict::holds : Verdict::fails;  // NaN: not enough
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
    const std::string unit = unit_ == Unit::none ? "" : " " + symbol();
    return fmt::format("{:.4g}{}", value, unit);
  }
  std::string symbol() const {
    const std::string text = quantity_text(1.0, unit_);
    return text.substr(text.find(' ') + 1);
  }

  // The comparison that is nearest to failing, and how many failed.
  std::string figures_of(const std::vector<Comparison>& all) const {
    const auto worst =
        std::min_element(all.begin(), all.end(), [](const Comparison& a, const Comparison& b) {
          if (a.verdict != b.verdict) return a.verdict < b.verdict;
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
    text = fmt::format("worst at {}: {}; {} of {} hold", where, text, count_of(all, Verdict::holds),
                       all.size());
    const int not_judged = count_of(all, Verdict::not_judged);
    if (not_judged > 0) text += fmt::format(", {} without a value", not_judged);
    return text;
  }

  void add_sign_test(ClaimResult& result) const {
    const std::vector<int> levels = levels_of(claim_, results_);
    const int own = variant_index(results_, claim_.of);
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
      if (difference > 0.0) ++wins;
      if (difference < 0.0) ++losses;
    }
    const double p = sign_test_probability(wins, losses);
    result.held = result.held && p < kSignificance;
    result.measured +=
        fmt::format("; sign test: {} pairs for it, {} against, p = {:.3g}", wins, losses, p);
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

void read_where(const ConfigNode& node, Claim& claim) {
  const ConfigNode* at = node.find("at");
  if (at == nullptr) return;
  if (at->kind() == ConfigNode::Kind::map) {
    claim.where = Claim::Where::given;
    for (const Setting& setting : settings_of(*at))
      claim.at.emplace_back(setting.path, setting.text);
    return;
  }
  claim.where = static_cast<Claim::Where>(at->choice({"every level", "upper half"}));
}

void read_bound(const ConfigNode& node, Claim& claim) {
  int found = 0;
  for (std::size_t i = 0; i < kRelations.size(); ++i) {
    const ConfigNode* bound = node.find(kRelations[i]);
    if (bound == nullptr) continue;
    claim.relation = static_cast<Claim::Relation>(i);
    claim.against = bound->text();
    ++found;
  }
  if (found != 1) {
    throw InputError(
        node.place(),
        found == 0 ? "the claim compares with nothing" : "the claim compares with two things",
        "give one of at_most, at_least, below, above, equals");
  }
}

}  // namespace

Claim claim_of(const ConfigNode& node) {
  Claim claim{.place = node.place()};
  claim.metric = node.at("metric").text();
  if (const ConfigNode* of = node.find("of")) claim.of = of->text();
  if (const ConfigNode* statistic = node.find("statistic")) {
    claim.statistic = static_cast<Claim::Statistic>(statistic->choice(kStatistics));
  }
  read_bound(node, claim);
  if (const ConfigNode* other = node.find("against_metric")) claim.against_metric = other->text();
  if (const ConfigNode* times = node.find("times")) claim.times = times->number();
  if (const ConfigNode* within = node.find("within")) claim.within = within->text();
  read_where(node, claim);
  if (const ConfigNode* test = node.find("test")) claim.sign_test = test->choice({"sign"}) == 0;
  if (const ConfigNode* thesis = node.find("thesis")) claim.thesis = thesis->text();
  if (claim.relation == Claim::Relation::equals && claim.within.empty()) {
    throw InputError(node.place(), "a claim of equality says nothing about how exact",
                     "add e.g. 'within: 1e-9'");
  }
  return claim;
}

void check_claim(const Claim& claim, const Results& plan) {
  std::vector<std::string> metrics;
  for (const Metric& metric : plan.metrics) metrics.push_back(metric.name);
  for (const std::string& name : {claim.metric, claim.against_metric}) {
    if (name.empty() || metric_index(plan, name) >= 0) continue;
    throw InputError(
        claim.place,
        "the claim is about " + in_quotes(name) + ", which is none of the scenario's metrics",
        suggestion(name, metrics));
  }
  if (!claim.of.empty() && variant_index(plan, claim.of) < 0) {
    throw InputError(claim.place, in_quotes(claim.of) + " is not compared in this scenario",
                     suggestion(claim.of, plan.variants));
  }
  const Unit unit = plan.metrics[static_cast<std::size_t>(metric_index(plan, claim.metric))].unit;
  const bool is_variant = variant_index(plan, claim.against) >= 0;
  const bool looks_like_a_name = claim.against.find_first_of("0123456789") == std::string::npos;
  if (!is_variant && looks_like_a_name) {
    throw InputError(claim.place, in_quotes(claim.against) + " is neither a variant nor a number",
                     suggestion(claim.against, plan.variants));
  }
  if (!is_variant) (void)parse_quantity(claim.against, unit, claim.place);
  if (!claim.within.empty()) (void)parse_quantity(claim.within, unit, claim.place);
  if (claim.sign_test && (!is_variant || claim.of.empty())) {
    throw InputError(claim.place, "a sign test compares two variants", "give 'of' and the other");
  }
  std::vector<std::string> paths;
  for (const SweepAxis& axis : plan.axes) paths.push_back(axis.path);
  for (const auto& [path, value] : claim.at) {
    const int axis = axis_index(plan, path);
    if (axis < 0) {
      throw InputError(claim.place, in_quotes(path) + " is not swept", suggestion(path, paths));
    }
    const auto& texts = plan.axes[static_cast<std::size_t>(axis)].texts;
    if (plan.quick || std::find(texts.begin(), texts.end(), value) != texts.end()) continue;
    throw InputError(claim.place, "the sweep of '" + path + "' has no value " + in_quotes(value),
                     suggestion(value, texts));
  }
}

ClaimResult judge(const Claim& claim, const Results& results) {
  return Judge(claim, results).result();
}

std::string text_of(const Claim& claim, const Results& results) {
  std::string text;
  if (claim.statistic != Claim::Statistic::mean) {
    text = kStatistics[static_cast<std::size_t>(claim.statistic)] + " of ";
  }
  text += claim.metric;
  if (!claim.of.empty()) text += " of '" + claim.of + "'";
  text += " is " + kRelationWords[static_cast<std::size_t>(claim.relation)] + " ";
  if (claim.times != 1.0) text += fmt::format("{:g} times ", claim.times);
  if (variant_index(results, claim.against) >= 0) {
    text += claim.against_metric.empty() ? "that" : claim.against_metric;
    text += " of '" + claim.against + "'";
  } else {
    text += claim.against;
  }
  if (!claim.within.empty()) text += " within " + claim.within;
  if (claim.where == Claim::Where::upper_half) text += ", in the upper half of the levels";
  if (claim.where == Claim::Where::every_level && results.levels.size() > 1) {
    text += ", at every level";
  }
  for (const auto& [path, value] : claim.at) {
    text += ", at " + path.substr(path.rfind('.') + 1) + " = " + value;
  }
  return text;
}

}  // namespace mapbed
