#pragma once

namespace mapbed {

// The one-sided sign test: the probability that `wins` or more of all pairs go that way where
// either way is as likely. Pairs that are equal count on neither side.
double sign_test_probability(int wins, int losses);

}  // namespace mapbed
