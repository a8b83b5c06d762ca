#pragma once

#include "algorithms/association_tree.h"

namespace mapbed {

// Five local maps. The fourth was first taken for a new place; with the fifth it was found to be
// the first one again:
//
//   0 ── 1 ── 2 ──┬── 3 (new) ── 5 (new)            taken back when the fifth map was there
//                 └── 4 (first map) ── 6 (second)   chosen
inline AssociationTree example_associations() {
  AssociationTree tree;
  tree.local_maps = {{0.0, 5.0}, {5.0, 10.0}, {10.0, 15.0}, {15.0, 20.0}, {20.0, 25.5}};
  tree.nodes = {{-1, 0, -1, -10.0, true}, {0, 1, -1, -20.0, true}, {1, 2, -1, -30.25, true},
                {2, 3, -1, -40.0, true},  {2, 3, 0, -42.0, true},  {3, 4, -1, -90.0, false},
                {4, 4, 1, -51.125, false}};
  tree.choices = {{5.0, 0, -10.0, -10.0},
                  {10.0, 1, -20.0, -10.0},
                  {15.0, 2, -30.25, -10.25},
                  {20.0, 3, -40.0, -9.75},
                  {25.5, 6, -51.125, -9.125}};
  tree.revisions = {{.time = 25.5,
                     .at = 4,
                     .since = 3,
                     .changed = 2,
                     .before = 5,
                     .after = 6,
                     .log_likelihood_before = -90.0,
                     .log_likelihood_after = -51.125}};
  tree.chosen = 6;
  return tree;
}

}  // namespace mapbed
