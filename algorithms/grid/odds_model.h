#pragma once

#include "core/config/option.h"

namespace mapbed {

// How the odds model (2.5)-(2.13) takes one look at a cell, (2.12).
struct OddsModel {
  double p_occ = 0.8;   // a beam ended in the cell
  double p_free = 0.2;  // a beam went through the cell
  double prior = 0.5;   // nothing was seen of it
  double lowest = 0.0;  // what a cell can fall to and rise to: 0 and 1 mean no bounds
  double highest = 1.0;
};

template <class Visitor>
void visit_fields(OddsModel& o, Visitor&& visit) {
  visit("p_occ", o.p_occ, kFraction,
        "probability that a cell is occupied, given that a beam ended there");
  visit("p_free", o.p_free, kFraction, "the same, given that a beam went through it");
  visit("prior", o.prior, kFraction, "the same, before anything was seen");
  visit("lowest", o.lowest, kFraction,
        "bound that a cell's probability cannot fall below; 0: none");
  visit("highest", o.highest, kFraction,
        "bound that a cell's probability cannot rise above; 1: none");
}

// Throws InputError unless 0 < p_free < prior < p_occ < 1 and lowest < prior < highest.
void check(const OddsModel& model);

double log_odds(double probability);     // (2.6): ln(p / (1 - p)), 0 < p < 1
double probability_of(double log_odds);  // (2.10)

// (2.13) put right: the probability of a cell in which c_occ beams ended and through which c_free
// went, without bounds:
//
//   exp(l) / (1 + exp(l)),  l = l_0 + c_occ (l_occ - l_0) + c_free (l_free - l_0),
//
// where l_0, l_occ and l_free are the log odds of the prior, p_occ and p_free. (The printed form
// has the probabilities themselves in the exponent and never falls below 0.5.) c_free = 0 is
// (2.16).
double odds_occupancy(double c_occ, double c_free, const OddsModel& model = {});

}  // namespace mapbed
