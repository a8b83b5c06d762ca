#include "bench/metrics/identity_f1.h"

#include <limits>
#include <map>
#include <utility>

#include "core/assignment.h"

namespace mapbed {
double identity_f1(const TrackingFrames& frames, double max_distance) {
  std::map<int, int> truths, tracks;
  std::map<std::pair<int, int>, double> together;  // frames in which two are near
  double all = 0.0;                                // objects over all frames, true and tracked
  for (const TrackingFrame& frame : frames) {
    all += static_cast<double>(frame.truth.size() + frame.tracks.size());
    for (const TrackedObject& track : frame.tracks) number_of(tracks, track.id);
    for (const TrueObject& object : frame.truth) {
      const int i = number_of(truths, object.id);
      for (const TrackedObject& track : frame.tracks) {
        if ((object.position - track.position).norm() > max_distance) continue;
        together[{i, number_of(tracks, track.id)}] += 1.0;
      }
    }
  }
  if (all == 0.0) return std::numeric_limits<double>::quiet_NaN();
  Eigen::MatrixXd cost = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(truths.size()),
                                               static_cast<Eigen::Index>(tracks.size()));
  for (const auto& [pair, count] : together) cost(pair.first, pair.second) = -count;
  const double agreed = -cost_of(cheapest_assignment(cost), cost);
  return 2.0 * agreed / all;
}

}  // namespace mapbed
