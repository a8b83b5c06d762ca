#pragma once

#include "algorithms/grid/beam_likelihood.h"

namespace mapbed {

// One beam of section 4.2 whose cause is hidden: c = 1 if something static reflected it, with
// probability p = p(c) before it was measured. `hit` is false for a maximum-range beam (zeta = 1),
// whose path counts like that of every other beam and whose end cell says nothing.

// ln p(z | c, x, m), (4.1).
double log_likelihood_given_cause(const BeamTerms& terms, bool hit, bool c);

// ln p(z, c | x, m) = ln p(z | c, x, m) + ln p(c): the chain rule, which (4.3) and (4.4) print
// without the condition on c. Summed over beams it is (4.6).
double log_joint_likelihood(const BeamTerms& terms, bool hit, bool c, double p);

// e = E[c | z, x, m], (4.10): p for a maximum-range beam.
double expectation_of_cause(const BeamTerms& terms, bool hit, double p);

// The beam's term of (4.7) less that of gamma: the path of every beam, and its end cell unless
// zeta = 1. (Printed with the path outside the sum over beams.)
double expected_log_likelihood(const BeamTerms& terms, bool hit, double e);

// The beam's term of gamma, (4.9): e ln p + (1 - e) ln(1 - p). Constant within one M-step only.
double expected_log_prior(double e, double p);

}  // namespace mapbed
