#pragma once

#include "bench/experiments/false_loops/lattice_drive.h"
#include "core/geometry/angle.h"

namespace mapbed {

// As Suenderhauf and Protzel (2012) spoil graphs: two places are taken for one that are not.
enum class FalseLoopKind : int {
  random,  // each by itself
  grouped  // as where one street looks like another: runs of several that agree with one another
};

struct FalseLoopOptions {
  FalseLoopKind kind = FalseLoopKind::random;
  double share = 0.0;  // of all loop closures, the right ones among them
  int group = 10;
  double sigma = 0.3;                 // [m]
  double turn_sigma = radians(10.0);  // [rad]
};

template <class Visitor>
void visit_fields(FalseLoopOptions& o, Visitor&& visit) {
  visit("kind", o.kind, {"random", "grouped"},
        "each false loop closure by itself, or runs of several that agree with one another");
  visit("share", o.share, between(0.0, 0.99),
        "of all loop closures, how many are false; these are added to the right ones");
  visit("group", o.group, between(1, 100'000),
        "false loop closures of a run, where they are grouped");
  visit("sigma", o.sigma, Unit::meter, kNotNegative,
        "how far apart two places lie, by each coordinate, that are falsely taken for one");
  visit("turn_sigma", o.turn_sigma, Unit::radian, kNotNegative, "the same of each angle");
}

// Adds them behind all others. Each has the information of one of the right ones, and is at least
// ten sigma off the truth. With a larger share those of a smaller one come first. Throws InputError
// where the graph is too short for them.
template <class Pose>
void add_false_loops(const FalseLoopOptions& options, const Rng& rng, KnownGraph<Pose>& known);

}  // namespace mapbed
