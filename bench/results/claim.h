#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/config/config_node.h"
#include "core/input_error.h"

namespace mapbed {

struct Results;

// A statement about what is measured. It is checked and reported, never tuned to hold.
//
//   {metric: failures, of: matched, at_most: raw, at: every level}
//   {metric: relative_translation, of: matched, at_most: raw, times: 0.1, thesis: raw is unusable}
//   {metric: occupancy, of: counting, equals: 0.7, within: 1e-9, at: {hits: 70}}
//   {metric: success_rate, of: blurred, above: sharp, at: upper half, test: sign}
//   {series: residual, take: last, of: matched, at_most: 1 cm}
//   {series: map_error, of: matched, below: raw, at: {time: 10 s}}
struct Claim {
  enum class Take : int { first, last, at };
  enum class Statistic : int { mean, median, min, max, total };
  enum class Relation : int { at_most, at_least, below, above, equals };
  enum class Where : int { every_level, upper_half, given };

  SourceLocation place;
  std::string metric;  // or, if is_series, the name of a series
  bool is_series = false;
  Take take = Take::last;  // of a series: which of its values
  std::string of;          // a variant; empty: every one
  Statistic statistic = Statistic::mean;
  Relation relation = Relation::at_most;
  std::string against;         // as written: a number with unit, or a variant
  std::string against_metric;  // of that variant; empty: the same metric
  double times = 1.0;          // what it is compared with is multiplied by this
  std::string within;          // equals: how far it may be off, as written
  Where where = Where::every_level;
  // given: path and value of axes; besides, with Take::at, name and value of the series' x
  std::vector<std::pair<std::string, std::string>> at;
  bool sign_test = false;  // besides: pairs of runs of one level and seed differ that way more
                           // often than chance would have it (p < 5 %)
  std::string thesis;      // what the thesis says
};

// What came of a claim.
struct Verdict {
  std::string claim;  // "failures of filter on at most those of filter off, at every level"
  bool held = false;
  bool judged = true;    // false: the run has no such level, or no value there
  std::string measured;  // the figures: "worst at rotation_sigma = 8 deg: 0.12 against 0.30"
  std::string thesis;    // what the thesis says; empty: nothing
  bool of_cost = false;  // about time, which differs from run to run of the same program
};

// "held", "not held" or "not judged". A quick run is a smaller one and gives no verdict: it only
// tells how it came out, "quick: holds", "quick: holds not".
std::string text_of(const Verdict& verdict, bool quick);

Claim claim_of(const ConfigNode& node);

// One line, of which claim_of makes the same again.
std::string claim_text(const Claim& claim);

// "error of 'a' is at most that of 'b', at every level"
std::string sentence_of(const Claim& claim, const Results& plan);

}  // namespace mapbed
