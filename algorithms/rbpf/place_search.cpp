#include "algorithms/rbpf/place_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Dense>

namespace mapbed {
namespace {

constexpr double kClearlyMore = 0.1;
constexpr double kSigmas = 3.0;     // of the prior that are searched
constexpr double kMaxShift = 0.6;   // [m] each way
constexpr double kMaxTurn = 0.6;    // [rad] each way
constexpr double kStep = 1.5;       // [cells] as far as Gauss-Newton sees
constexpr double kMinStep = 0.005;  // [rad]
constexpr double kNearRange = 1.0;  // [m] hits count as at least so far off for the step of turns

// Steps from -window to window, 0 among them.
std::vector<double> lattice(double window, double step) {
  const int count = static_cast<int>(window / step);
  std::vector<double> result;
  for (int i = -count; i <= count; ++i) result.push_back(i * step);
  return result;
}

// [rad] that moves a hit by a step in the mean.
double turn_step(const ScanForWeighting& scan, double step) {
  double sum = 0.0;
  for (const Eigen::Vector2d& hit : scan.hits) sum += hit.norm();
  return std::max(kMinStep,
                  step / std::max(kNearRange, sum / static_cast<double>(scan.hits.size())));
}

std::vector<Pose2> poses_about(const PosePrior& prior, double step, double turn) {
  const Eigen::Vector3d sigmas = prior.information.inverse().diagonal().cwiseSqrt();
  const std::vector<double> ahead = lattice(std::min(kMaxShift, kSigmas * sigmas.x()), step);
  const std::vector<double> aside = lattice(std::min(kMaxShift, kSigmas * sigmas.y()), step);
  std::vector<Pose2> poses;
  for (const double theta : lattice(std::min(kMaxTurn, kSigmas * sigmas.z()), turn)) {
    for (const double x : ahead) {
      for (const double y : aside) poses.push_back(prior.mean * Pose2{x, y, theta});
    }
  }
  return poses;
}

}  // namespace

std::optional<Pose2> likelier_place(const Pose2& guess, const ScanForWeighting& scan,
                                    const SurfaceMap& map, const PosePrior& prior,
                                    const SurfaceLikelihood& likelihood, double enough) {
  if (scan.hits.empty()) return {};
  const LocalPosterior near = likelihood.local_posterior(guess, scan, map, prior);
  const double explained = likelihood.inlier_ratio(scan, map, near.mode);
  if (explained >= enough) return {};
  const double step = kStep * map.resolution();
  Pose2 best = near.mode;
  double most = -std::numeric_limits<double>::infinity();
  for (const Pose2& pose : poses_about(prior, step, turn_step(scan, step))) {
    const double log_posterior = likelihood.log_posterior(scan, map, pose, prior);
    if (log_posterior <= most) continue;
    best = pose;
    most = log_posterior;
  }
  const LocalPosterior found = likelihood.local_posterior(best, scan, map, prior);
  const bool better = found.log_evidence > near.log_evidence &&
                      likelihood.inlier_ratio(scan, map, found.mode) >= explained + kClearlyMore;
  return better ? std::optional<Pose2>(found.mode) : std::optional<Pose2>{};
}

}  // namespace mapbed
