#include "bench/results/claim.h"

#include <fmt/format.h>

#include "bench/results/flow_text.h"
#include "bench/results/results.h"
#include "core/file/csv_file.h"

namespace mapbed {
namespace {

const std::vector<std::string> kTakes{"first", "last"};
const std::vector<std::string> kStatistics{"mean", "median", "min", "max", "total"};
const std::vector<std::string> kRelations{"at_most", "at_least", "below", "above", "equals"};
const std::vector<std::string> kRelationWords{"at most", "at least", "below", "above", "equal to"};
const std::vector<std::string> kWheres{"every level", "upper half"};

template <class Enum>
const std::string& name_in(const std::vector<std::string>& names, Enum value) {
  return names[static_cast<std::size_t>(value)];
}

void read_subject(const ConfigNode& node, Claim& claim) {
  const ConfigNode* series = node.find("series");
  claim.is_series = series != nullptr;
  claim.metric = claim.is_series ? series->text() : node.at("metric").text();
  const ConfigNode* take = claim.is_series ? node.find("take") : nullptr;
  if (claim.is_series) claim.take = Claim::Take::at;
  if (take != nullptr) claim.take = static_cast<Claim::Take>(take->choice(kTakes));
  if (const ConfigNode* of = node.find("of")) claim.of = of->text();
}

void read_where(const ConfigNode& node, Claim& claim) {
  const ConfigNode* at = node.find("at");
  if (at == nullptr) return;
  if (at->kind() == ConfigNode::Kind::map) {
    claim.where = Claim::Where::given;
    for (const Setting& setting : settings_of(*at))
      claim.at.emplace_back(setting.path, setting.text);
    return;
  }
  claim.where = static_cast<Claim::Where>(at->choice(kWheres));
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

// As claim_of reads it; empty for every level.
std::string where_text(const Claim& claim) {
  if (claim.where == Claim::Where::every_level) return "";
  if (claim.where != Claim::Where::given) return name_in(kWheres, claim.where);
  std::vector<std::pair<std::string, std::string>> at;
  for (const auto& [path, value] : claim.at) at.emplace_back(path, flow_scalar(value));
  return flow_map(at);
}

}  // namespace

Claim claim_of(const ConfigNode& node) {
  Claim claim{.place = node.place()};
  read_subject(node, claim);
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

std::string claim_text(const Claim& claim) {
  const bool takes = claim.is_series && claim.take != Claim::Take::at;
  const bool is_mean = claim.statistic == Claim::Statistic::mean;
  return flow_map({{claim.is_series ? "series" : "metric", flow_scalar(claim.metric)},
                   {"take", takes ? name_in(kTakes, claim.take) : ""},
                   {"of", flow_scalar(claim.of)},
                   {"statistic", is_mean ? "" : name_in(kStatistics, claim.statistic)},
                   {name_in(kRelations, claim.relation), flow_scalar(claim.against)},
                   {"against_metric", flow_scalar(claim.against_metric)},
                   {"times", claim.times == 1.0 ? "" : csv_number(claim.times)},
                   {"within", flow_scalar(claim.within)},
                   {"at", where_text(claim)},
                   {"test", claim.sign_test ? "sign" : ""},
                   {"thesis", flow_scalar(claim.thesis)}});
}

std::string sentence_of(const Claim& claim, const Results& plan) {
  std::string text;
  if (claim.statistic != Claim::Statistic::mean) {
    text = name_in(kStatistics, claim.statistic) + " of ";
  }
  if (claim.is_series && claim.take != Claim::Take::at) text += name_in(kTakes, claim.take) + " ";
  text += claim.metric;
  if (!claim.of.empty()) text += " of '" + claim.of + "'";
  text += " is " + name_in(kRelationWords, claim.relation) + " ";
  if (claim.times != 1.0) text += fmt::format("{:g} times ", claim.times);
  if (variant_index(plan, claim.against) >= 0) {
    text += claim.against_metric.empty() ? "that" : claim.against_metric;
    text += " of '" + claim.against + "'";
  } else {
    text += claim.against;
  }
  if (!claim.within.empty()) text += " within " + claim.within;
  if (claim.where == Claim::Where::upper_half) text += ", in the upper half of the levels";
  if (claim.where == Claim::Where::every_level && plan.levels.size() > 1) {
    text += ", at every level";
  }
  for (const auto& [path, value] : claim.at) {
    text += ", at " + path.substr(path.rfind('.') + 1) + " = " + value;
  }
  return text;
}

std::string text_of(const Verdict& verdict, bool quick) {
  if (!verdict.judged) return quick ? "quick: not judged" : "not judged";
  if (quick) return verdict.held ? "quick: holds" : "quick: holds not";
  return verdict.held ? "held" : "not held";
}

}  // namespace mapbed
