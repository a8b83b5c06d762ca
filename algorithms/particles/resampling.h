#pragma once

#include <cstddef>
#include <vector>

#include "core/random.h"

namespace mapbed {

// When and how particles are drawn anew.
enum class Resampling : int {
  never,
  always,     // after every weighting
  selective,  // when the effective number of particles falls below a fraction of their number
};

// Normalised weights from logarithms, the largest taken out first. Where none is finite: all alike.
std::vector<double> normalized(const std::vector<double>& log_weights);

// 1 / sum w^2 of normalised weights: 1 … n.
double effective_number(const std::vector<double>& weights);

// Low-variance (systematic) resampling: which particle each of the new ones descends from, in
// ascending order; a particle of weight w appears floor(n w) or ceil(n w) times. As many new ones
// as there are, or `count` > 0.
std::vector<std::size_t> resampled(const std::vector<double>& weights, Rng& rng);
std::vector<std::size_t> resampled(const std::vector<double>& weights, std::size_t count, Rng& rng);

}  // namespace mapbed
