#include "bench/metrics/hota.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "core/assignment.h"

namespace mapbed {
namespace {

constexpr int kThresholds = 19;

double threshold(int number) {
  return 0.05 * (number + 1);
}

// A frame with its objects by their numbers in the whole recording.
struct Frame {
  std::vector<int> truths, tracks;
  Eigen::MatrixXd similarity;
};

struct Recording {
  std::vector<Frame> frames;
  Eigen::VectorXd frames_of_truth, frames_of_track;
};

Recording numbered(const TrackingFrames& frames, double zero_distance) {
  Recording result;
  std::map<int, int> truths, tracks;
  for (const TrackingFrame& frame : frames) {
    Frame& numbered = result.frames.emplace_back();
    for (const TrueObject& o : frame.truth) numbered.truths.push_back(number_of(truths, o.id));
    for (const TrackedObject& o : frame.tracks) numbered.tracks.push_back(number_of(tracks, o.id));
    numbered.similarity.resize(static_cast<Eigen::Index>(frame.truth.size()),
                               static_cast<Eigen::Index>(frame.tracks.size()));
    for (std::size_t i = 0; i < frame.truth.size(); ++i) {
      for (std::size_t j = 0; j < frame.tracks.size(); ++j) {
        const double d = (frame.truth[i].position - frame.tracks[j].position).norm();
        numbered.similarity(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
            std::max(0.0, 1.0 - d / zero_distance);
      }
    }
  }
  result.frames_of_truth = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(truths.size()));
  result.frames_of_track = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(tracks.size()));
  for (const Frame& frame : result.frames) {
    for (const int i : frame.truths) result.frames_of_truth[i] += 1.0;
    for (const int j : frame.tracks) result.frames_of_track[j] += 1.0;
  }
  return result;
}

double jaccard(double both, double a, double b) {
  return both / (a + b - both);
}

// How much two identities belong together over the whole recording: the Jaccard index of how often
// they might be matched.
Eigen::MatrixXd alignment_of(const Recording& recording) {
  Eigen::MatrixXd together =
      Eigen::MatrixXd::Zero(recording.frames_of_truth.size(), recording.frames_of_track.size());
  for (const Frame& frame : recording.frames) {
    const Eigen::MatrixXd& s = frame.similarity;
    for (Eigen::Index i = 0; i < s.rows(); ++i) {
      for (Eigen::Index j = 0; j < s.cols(); ++j) {
        const double all = s.row(i).sum() + s.col(j).sum() - s(i, j);
        if (all > 0.0)
          together(frame.truths[static_cast<std::size_t>(i)],
                   frame.tracks[static_cast<std::size_t>(j)]) += s(i, j) / all;
      }
    }
  }
  for (Eigen::Index i = 0; i < together.rows(); ++i) {
    for (Eigen::Index j = 0; j < together.cols(); ++j) {
      together(i, j) =
          jaccard(together(i, j), recording.frames_of_truth[i], recording.frames_of_track[j]);
    }
  }
  return together;
}

// Of one threshold.
struct Counts {
  double truths = 0.0, tracks = 0.0, matches = 0.0;
  Eigen::MatrixXd by_pair;

  double detection() const { return jaccard(matches, truths, tracks); }
  double association(const Recording& recording) const {
    if (matches == 0.0) return 0.0;
    double sum = 0.0;
    for (Eigen::Index i = 0; i < by_pair.rows(); ++i) {
      for (Eigen::Index j = 0; j < by_pair.cols(); ++j) {
        if (by_pair(i, j) == 0.0) continue;
        sum += by_pair(i, j) *
               jaccard(by_pair(i, j), recording.frames_of_truth[i], recording.frames_of_track[j]);
      }
    }
    return sum / matches;
  }
};

void count(const Frame& frame, const Eigen::MatrixXd& alignment,
           std::array<Counts, kThresholds>& counts) {
  Eigen::MatrixXd cost = -frame.similarity;
  for (Eigen::Index i = 0; i < cost.rows(); ++i) {
    for (Eigen::Index j = 0; j < cost.cols(); ++j) {
      cost(i, j) *= alignment(frame.truths[static_cast<std::size_t>(i)],
                              frame.tracks[static_cast<std::size_t>(j)]);
    }
  }
  const std::vector<int> track_of = cheapest_assignment(cost);
  for (int k = 0; k < kThresholds; ++k) {
    Counts& c = counts[static_cast<std::size_t>(k)];
    c.truths += static_cast<double>(frame.truths.size());
    c.tracks += static_cast<double>(frame.tracks.size());
    for (std::size_t i = 0; i < track_of.size(); ++i) {
      const int j = track_of[i];
      constexpr double kRounding = 1e-12;
      if (j < 0 || frame.similarity(static_cast<Eigen::Index>(i), j) < threshold(k) - kRounding) {
        continue;
      }
      c.matches += 1.0;
      c.by_pair(frame.truths[i], frame.tracks[static_cast<std::size_t>(j)]) += 1.0;
    }
  }
}

}  // namespace

Hota hota(const TrackingFrames& frames, double zero_distance) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const Recording recording = numbered(frames, zero_distance);
  if (recording.frames_of_truth.size() + recording.frames_of_track.size() == 0) {
    return {kNone, kNone, kNone};
  }
  const Eigen::MatrixXd alignment = alignment_of(recording);
  std::array<Counts, kThresholds> counts;
  for (Counts& c : counts) c.by_pair = Eigen::MatrixXd::Zero(alignment.rows(), alignment.cols());
  for (const Frame& frame : recording.frames) count(frame, alignment, counts);
  Hota result;
  for (const Counts& c : counts) {
    const double detection = c.detection(), association = c.association(recording);
    result.hota += std::sqrt(detection * association) / kThresholds;
    result.detection += detection / kThresholds;
    result.association += association / kThresholds;
  }
  return result;
}

}  // namespace mapbed
