#include "bench/results/claim_check.h"

#include <algorithm>

#include "bench/results/cost_claims.h"
#include "bench/results/series_claims.h"
#include "core/config/quantity.h"
#include "core/config/suggestion.h"

namespace mapbed {
namespace {

void check_metrics(const Claim& claim, const Results& plan) {
  std::vector<std::string> known;
  for (const Metric& metric : plan.metrics) known.push_back(metric.name);
  for (const std::string& name : {claim.metric, claim.against_metric}) {
    if (name.empty() || metric_index(plan, name) >= 0) continue;
    throw InputError(claim.place,
                     "the claim is about " + in_quotes(name) +
                         ", which is none of the scenario's " +
                         (claim.is_series ? "series" : "metrics"),
                     suggestion(name, known));
  }
}

void check_comparison(const Claim& claim, const Results& plan) {
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
}

// A quick run may lack some of the values.
void check_levels(const Claim& claim, const Results& plan) {
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

void check_on_metrics(const Claim& claim, const Results& plan) {
  check_metrics(claim, plan);
  check_comparison(claim, plan);
  check_levels(claim, plan);
}

}  // namespace

void check_claim(const Claim& claim, const Results& plan) {
  if (claim.is_series) {
    const Results names = with_series_as_metrics(plan, {});
    check_metrics(claim, names);
    check_taken_value(claim, plan);
    check_on_metrics(as_metric_claim(claim, plan), names);
  } else {
    check_on_metrics(claim, is_about_cost(claim) ? with_costs_as_metrics(plan) : plan);
  }
}

}  // namespace mapbed
