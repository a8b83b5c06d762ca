#pragma once

#include <cstddef>

#include "core/config/option.h"

namespace mapbed {

// How many particles a belief needs (Fox, Adapting the sample size in particle filters through
// KLD-sampling, 2003): with this number the distance of what they say from the true belief over the
// boxes of poses is below an error with a probability.
struct ParticleNumberOptions {
  int least = 500;
  int most = 20'000;
  double error = 0.05;        // Kullback-Leibler distance
  double probability = 0.99;  // with which it is kept
};

template <class Visitor>
void visit_fields(ParticleNumberOptions& o, Visitor&& visit) {
  visit("least", o.least, between(1, 10'000'000), "particles at least");
  visit("most", o.most, between(1, 10'000'000), "particles at most; also where nothing is known");
  visit("error", o.error, between(1e-4, 1.0),
        "Kullback-Leibler distance of the particles from the belief that they stand for");
  visit("probability", o.probability, between(0.5, 0.9999), "with which that error is kept");
}

// For a belief in so many boxes, between the least and the most.
std::size_t particle_number(std::size_t occupied_bins, const ParticleNumberOptions& options);

}  // namespace mapbed
