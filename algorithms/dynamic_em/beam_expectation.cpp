#include "algorithms/dynamic_em/beam_expectation.h"

#include <cmath>

namespace mapbed {

double log_likelihood_given_cause(const BeamTerms& terms, bool hit, bool c) {
  if (!hit) return terms.log_path;
  return terms.log_path + std::log(c ? terms.m_end : 1.0 - terms.m_end);
}

double log_joint_likelihood(const BeamTerms& terms, bool hit, bool c, double p) {
  return log_likelihood_given_cause(terms, hit, c) + std::log(c ? p : 1.0 - p);
}

double expectation_of_cause(const BeamTerms& terms, bool hit, double p) {
  if (!hit) return p;
  return p / (p + (1.0 - p) * (1.0 / terms.m_end - 1.0));
}

double expected_log_likelihood(const BeamTerms& terms, bool hit, double e) {
  if (!hit) return terms.log_path;
  return terms.log_path + e * std::log(terms.m_end) + (1.0 - e) * std::log(1.0 - terms.m_end);
}

double expected_log_prior(double e, double p) {
  return e * std::log(p) + (1.0 - e) * std::log(1.0 - p);
}

}  // namespace mapbed
