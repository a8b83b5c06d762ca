#pragma once

#include <Eigen/Core>

#include "core/config/option.h"

namespace mapbed {

struct JointAssociationOptions {
  int max_events = 500;
  int best_events = 40;
};

template <class Visitor>
void visit_fields(JointAssociationOptions& o, Visitor&& visit) {
  visit("max_events", o.max_events, between(1, 1'000'000),
        "of a cluster of people and features, up to which all joint events are summed up");
  visit("best_events", o.best_events, between(1, 100'000),
        "most likely joint events that are summed up of a larger cluster");
}

// Which features are of whom.
struct JointAssociation {
  Eigen::MatrixXd gamma;   // (i, j): probability that person i caused feature j, (3.1)
  Eigen::VectorXd missed;  // (i): that he caused none, gamma_0i
  long events = 0;         // joint events that were summed up
  int cut_clusters = 0;    // clusters of which these were not all
};

// Joint probabilistic data association, (3.1) and (3.2): the probability of a joint event is, up to
// a constant,
//
//   prod_{unassigned j} p_fa(j) * prod_{(j,i), j >= 1} p(j, i) * prod_{(0,i)} missed(i)
//
// with p(j, i) the likelihood of feature j for person i, his being detected included, 0 outside of
// his gate; p_fa(j) the likelihood of the feature as a false alarm, which (3.2) prints with the
// symbol of the event itself. The exponent of that is the number of features which the event leaves
// unassigned. People and features that share no gate are independent of each other; each cluster is
// summed up on its own, exactly as long as it has at most max_events.
JointAssociation associate(const Eigen::MatrixXd& likelihood, const Eigen::VectorXd& missed,
                           const Eigen::VectorXd& p_fa, const JointAssociationOptions& options);

}  // namespace mapbed
