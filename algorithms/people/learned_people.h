#pragma once

#include "algorithms/people/moved_features.h"
#include "algorithms/people/people_number.h"

// What was learned of people and of everything else from simulated drives whose truth is known.

namespace mapbed {

// What tells a person who walks from what belongs to the place: that he comes to new places, what
// stood there before (he himself apart), what is now where he was, and how steadily he is seen.
struct Evidence {
  enum class Kind { step, stay, missed };  // to a new place, not for a while, not seen for a while
  enum class Left {
    nowhere,  // he is still about where he was
    unknown,  // nobody sees that place now
    free,     // nothing is there any more
    same,     // something is: a track that jumped from one thing to the next
  };
  Kind kind = Kind::stay;
  SeenBefore before = SeenBefore::nothing;
  Left left = Left::nowhere;
  bool is_steady = true;  // he was seen all the time since the step before, and made no jump

  double log_ratio() const;  // ln P(this | person who walks) / P(this | anything else)
};

// P(m | N) of (3.5) as it was counted; where there were few such scans, and beyond, the closed form
// of `detection` and `false_alarms` counts with as much as a few of them.
FeatureNumbers learned_feature_numbers(double detection, double false_alarms, int max_people);

}  // namespace mapbed
