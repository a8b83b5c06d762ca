#pragma once

#include <map>
#include <vector>

#include <Eigen/Core>

namespace mapbed {

// Who was truly there at the moment of a scan.
struct TrueObject {
  int id = 0;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // [m]
  // False: nobody is asked to find it (hidden, too far away, it does not move), nor blamed for it.
  bool counts = true;
  bool is_hidden = false;  // by something nearer; who hides does not count
  bool has_moved = true;   // since it came into view
};

// Who was held to be there.
struct TrackedObject {
  int id = 0;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // [m] in the truth's frame
};

struct TrackingFrame {
  double time = 0.0;  // [s]
  std::vector<TrueObject> truth;
  std::vector<TrackedObject> tracks;
};

using TrackingFrames = std::vector<TrackingFrame>;  // by time

// Numbers from 0 on for ids, as they come: of rows and columns.
inline int number_of(std::map<int, int>& numbers, int id) {
  return numbers.emplace(id, static_cast<int>(numbers.size())).first->second;
}

// The pair (index into truth, index into tracks) of each true object that is matched, in the order
// of the truth: as many pairs as possible within `max_distance` [m], the shortest in sum.
struct MatchedPair {
  std::size_t truth = 0;
  std::size_t track = 0;
};
std::vector<MatchedPair> matched_pairs(const TrackingFrame& frame, double max_distance);

// Frames in which everybody counts: those who do not are left out, with the tracks that are matched
// to them where each frame is matched for itself (as MOTChallenge does).
TrackingFrames counting_alone(const TrackingFrames& frames, double max_distance);

}  // namespace mapbed
