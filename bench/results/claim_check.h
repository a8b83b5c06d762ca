#pragma once

#include "bench/results/claim.h"
#include "bench/results/results.h"

namespace mapbed {

// Throws InputError where a claim names a metric, series, variant, axis or unit that there is not.
void check_claim(const Claim& claim, const Results& plan);

}  // namespace mapbed
