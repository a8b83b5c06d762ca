#pragma once

#include <vector>

namespace mapbed {

// How likely a beam's end is at a distance d from the mapped surface: on it with the noise of beam,
// map and pose, or anywhere, by something that is not on the map,
//
//   ln(w exp(-d^2 / (2 sigma^2)) + 1 - w),    w = inlier_ratio,
//
// from outlier_log() far away up to 0 on the surface. As a table over d^2, linear in between.
class HitMixture {
 public:
  // `sigma` in the unit of the distances that are asked for; beyond `reach` sigmas the Gaussian
  // counts for nothing.
  HitMixture(double sigma, double inlier_ratio, double reach, int steps);

  // By d^2; far away for one that is not a number.
  float log_at(float squared) const {
    const float at = squared * steps_per_square_;
    if (!(at < steps_)) return far_;
    const int index = static_cast<int>(at);
    const float low = logs_[static_cast<std::size_t>(index)];
    const float high = logs_[static_cast<std::size_t>(index) + 1];
    return low + (at - static_cast<float>(index)) * (high - low);
  }

  struct Value {
    float log;
    float inlier;  // the probability that such a beam hit the surface: the Gaussian's part
  };
  Value at(float squared) const {
    const float at = squared * steps_per_square_;
    if (!(at < steps_)) return {far_, 0.0F};
    const int index = static_cast<int>(at);
    const float rest = at - static_cast<float>(index);
    const auto low = static_cast<std::size_t>(index);
    return {logs_[low] + rest * (logs_[low + 1] - logs_[low]),
            inliers_[low] + rest * (inliers_[low + 1] - inliers_[low])};
  }

  double outlier_log() const { return outlier_log_; }  // ln(1 - w)

  // The probability of a beam of that log-likelihood to have hit the surface.
  double inlier_probability(double log) const;

 private:
  double outlier_log_;
  float far_;               // the same
  float steps_per_square_;  // d^2 -> index into the tables
  float steps_;
  std::vector<float> logs_;
  std::vector<float> inliers_;
};

// 1: all beams of a scan lie on the map, 0: none does; by their log-likelihoods' sum, and what that
// would be if none did.
inline double inlier_ratio(double sum_of_logs, double sum_of_outliers) {
  return 1.0 - sum_of_logs / sum_of_outliers;
}

}  // namespace mapbed
