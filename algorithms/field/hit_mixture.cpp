#include "algorithms/field/hit_mixture.h"

#include <cmath>

#include "core/check.h"

namespace mapbed {

HitMixture::HitMixture(double sigma, double inlier_ratio, double reach, int steps)
    : outlier_log_(std::log1p(-inlier_ratio)),
      far_(static_cast<float>(outlier_log_)),
      steps_(static_cast<float>(steps)) {
  CHECK(sigma > 0.0 && inlier_ratio > 0.0 && inlier_ratio < 1.0);
  const double farthest = reach * sigma;
  steps_per_square_ = static_cast<float>(steps / (farthest * farthest));
  for (int i = 0; i <= steps; ++i) {
    const double squared_sigmas = reach * reach * i / steps;
    const double gauss = inlier_ratio * std::exp(-0.5 * squared_sigmas);
    const double mixture = gauss + 1.0 - inlier_ratio;
    logs_.push_back(static_cast<float>(std::log(mixture)));
    inliers_.push_back(static_cast<float>(gauss / mixture));
  }
}

double HitMixture::inlier_probability(double log) const {
  return 1.0 - std::exp(double{far_} - log);
}

}  // namespace mapbed
