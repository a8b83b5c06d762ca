#pragma once

#include "algorithms/submaps/loop_closer.h"
#include "algorithms/submaps/node_chain.h"
#include "core/config/option.h"

namespace mapbed {

struct GraphSlamOptions {
  NodeChainOptions chain;
  LoopCloserOptions loops;
};

template <class Visitor>
void visit_fields(GraphSlamOptions& o, Visitor&& visit) {
  visit_fields(o.chain, visit);
  visit("loops", o.loops, "how places that were seen before are found");
}

}  // namespace mapbed
