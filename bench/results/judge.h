#pragma once

#include "bench/results/claim.h"
#include "bench/results/results.h"

namespace mapbed {

// What a claim says of the results: by their summary and runs, or by their cost or series. A claim
// holds where it does so at all its levels and for all its variants; a level without any value, or
// with runs that have none, counts against it. Not judged is a claim that fails nowhere and has
// levels without a value because their runs were skipped or, in a quick run, too short to give one;
// runs that failed are never the reason. Nor is one judged in a quick run that does not judge, or
// whose sign test has so few pairs that it would not find for the claim if all of them were for it.
Verdict judge(const Claim& claim, const Results& results);

// Results::verdicts of all Results::claims; those about cost come last, as they do in files.
std::vector<Verdict> judge_all(const Results& results);

// Summary and verdicts anew, from the rows. False, and nothing done, where the claims are not there
// as data.
bool judge_again(Results& results);

}  // namespace mapbed
