#include "algorithms/grid/odds_model.h"

#include <cmath>

#include "core/check.h"
#include "core/input_error.h"

namespace mapbed {

void check(const OddsModel& model) {
  if (!(0.0 < model.p_free && model.p_free < model.prior && model.prior < model.p_occ &&
        model.p_occ < 1.0)) {
    throw InputError(
        "the odds model needs 0 < p_free < prior < p_occ < 1; "
        "the thesis has 0.2, 0.5 and 0.8");
  }
  if (!(model.lowest < model.prior && model.prior < model.highest)) {
    throw InputError(
        "the odds model needs lowest < prior < highest; "
        "0 and 1 mean no bounds");
  }
}

double log_odds(double probability) {
  CHECK(probability > 0.0 && probability < 1.0);
  return std::log(probability / (1.0 - probability));
}

double probability_of(double log_odds) {
  return 1.0 / (1.0 + std::exp(-log_odds));
}

double odds_occupancy(double c_occ, double c_free, const OddsModel& model) {
  const double l_0 = log_odds(model.prior);
  const double l_occ = log_odds(model.p_occ);
  const double l_free = log_odds(model.p_free);
  return probability_of(l_0 + c_occ * (l_occ - l_0) + c_free * (l_free - l_0));
}

}  // namespace mapbed
