#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/results/results.h"
#include "core/config/config_node.h"

namespace mapbed {

// A statement about what is measured. It is checked and reported, never tuned to hold.
//
//   {metric: failures, of: matched, at_most: raw, at: every level}
//   {metric: relative_translation, of: matched, at_most: raw, times: 0.1, thesis: raw is unusable}
//   {metric: occupancy, of: counting, equals: 0.7, within: 1e-9, at: {hits: 70}}
//   {metric: success_rate, of: blurred, above: sharp, at: upper half, test: sign}
struct Claim {
  enum class Statistic : int { mean, median, min, max, total };
  enum class Relation : int { at_most, at_least, below, above, equals };
  enum class Where : int { every_level, upper_half, given };

  SourceLocation place;
  std::string metric;
  std::string of;  // a variant; empty: every one
  Statistic statistic = Statistic::mean;
  Relation relation = Relation::at_most;
  std::string against;         // as written: a number with unit, or a variant
  std::string against_metric;  // of that variant; empty: the same metric
  double times = 1.0;          // what it is compared with is multiplied by this
  std::string within;          // equals: how far it may be off, as written
  Where where = Where::every_level;
  std::vector<std::pair<std::string, std::string>> at;  // given: path and value of axes
  bool sign_test = false;  // besides: pairs of runs of one level and seed differ that way more
                           // often than chance would have it (p < 5 %)
  std::string thesis;      // what the thesis says
};

Claim claim_of(const ConfigNode& node);

// Throws InputError where a claim names a metric, variant, axis or unit that there is not.
void check_claim(const Claim& claim, const Results& plan);

// By results.summary and results.runs. A claim holds where it does so at all its levels and for all
// its variants; a level without any value, or with runs that have none, counts against it. Not
// judged is a claim that fails nowhere and has levels without a value because their runs were
// skipped or, in a quick run, too short to give one; runs that failed are never the reason.
ClaimResult judge(const Claim& claim, const Results& results);

std::string text_of(const Claim& claim, const Results& results);

}  // namespace mapbed
