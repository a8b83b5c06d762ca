#pragma once

#include "algorithms/lazy_association/lazy_search.h"
#include "algorithms/lazy_association/submap_evidence.h"
#include "algorithms/submaps/loop_closer.h"
#include "algorithms/submaps/node_chain.h"
#include "core/config/option.h"

namespace mapbed {

struct LazySlamOptions {
  NodeChainOptions chain;
  LoopCloserOptions loops;
  LazySearchOptions search;
  SubmapEvidenceOptions evidence;
};

template <class Visitor>
void visit_fields(LazySlamOptions& o, Visitor&& visit) {
  visit_fields(o.chain, visit);
  visit("loops", o.loops, "how places that were seen before are found");
  visit("tree", o.search, "how far decisions are taken back");
  visit("evidence", o.evidence, "how likely what was seen is, under some decisions");
}

}  // namespace mapbed
