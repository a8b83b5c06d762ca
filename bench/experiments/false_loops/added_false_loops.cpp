#include "bench/experiments/false_loops/added_false_loops.h"

#include <algorithm>
#include <cmath>

#include "algorithms/pose_graph/constraint_error.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr double kFalseChiSquare = 100.0;  // at the truth, of what is false for certain
constexpr int kLeastBetween = 20;          // poses between two that are taken for one place
constexpr int kMostTrials = 1000;

template <class Pose>
Pose nearly_there(const FalseLoopOptions& options, Rng& rng) {
  PoseTangent<Pose> step;
  constexpr int kPlaces = kDegreesOfFreedom<Pose> == 3 ? 2 : 3;
  for (int i = 0; i < step.size(); ++i) {
    step[i] = rng.normal(0.0, i < kPlaces ? options.sigma : options.turn_sigma);
  }
  return moved(Pose{}, step);
}

// Poses i + k and j + k of a run are taken for one place, as i and j are, and as odometry leads
// from these to them.
template <class Pose>
std::vector<PoseConstraint<Pose>> false_run(const FalseLoopOptions& options, int length,
                                            const std::vector<PoseInformation<Pose>>& informations,
                                            const std::vector<Pose>& truth, Rng rng) {
  const std::uint64_t starts = truth.size() - static_cast<std::size_t>(length) + 1;
  auto from = static_cast<std::size_t>(rng.index(starts));
  auto to = static_cast<std::size_t>(rng.index(starts));
  if (from > to) std::swap(from, to);
  if (to - from < static_cast<std::size_t>(std::max(length, kLeastBetween))) return {};
  const Pose first = nearly_there<Pose>(options, rng);
  std::vector<PoseConstraint<Pose>> run;
  for (std::size_t k = 0; k < static_cast<std::size_t>(length); ++k) {
    const PoseInformation<Pose>& information = informations[rng.index(informations.size())];
    Pose motion = inverse(motion_between(truth[from], truth[from + k])) * first *
                  motion_between(truth[to], truth[to + k]);
    if (k > 0) motion = measured(motion, information, rng);
    run.push_back(
        {static_cast<int>(from + k), static_cast<int>(to + k), motion, information, true});
    if (chi_square_of(run.back(), truth) < kFalseChiSquare) return {};
  }
  return run;
}

}  // namespace

template <class Pose>
void add_false_loops(const FalseLoopOptions& options, const Rng& rng, KnownGraph<Pose>& known) {
  std::vector<PoseInformation<Pose>> informations;  // of the right ones
  for (const PoseConstraint<Pose>& constraint : known.graph.constraints) {
    if (constraint.closes_loop) informations.push_back(constraint.information);
  }
  auto missing = static_cast<std::size_t>(std::lround(static_cast<double>(informations.size()) *
                                                      options.share / (1.0 - options.share)));
  const int length = options.kind == FalseLoopKind::grouped ? options.group : 1;
  const bool has_room = known.truth.size() > static_cast<std::size_t>(2 * length + kLeastBetween);
  int failed = 0;
  for (std::uint64_t trial = 0; missing > 0; ++trial) {
    std::vector<PoseConstraint<Pose>> run;
    if (has_room) {
      run = false_run(options, length, informations, known.truth, rng.stream("false", trial));
    }
    failed = run.empty() ? failed + 1 : 0;
    if (!has_room || failed > kMostTrials) {
      throw InputError({}, "the graph is too short for this many false loop closures",
                       "take a longer one, or a smaller 'share' or 'group'");
    }
    run.resize(std::min(run.size(), missing));
    missing -= run.size();
    known.graph.constraints.insert(known.graph.constraints.end(), run.begin(), run.end());
  }
}

template void add_false_loops(const FalseLoopOptions&, const Rng&, KnownGraph<Pose2>&);
template void add_false_loops(const FalseLoopOptions&, const Rng&, KnownGraph<Pose3>&);

}  // namespace mapbed
