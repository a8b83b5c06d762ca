#include "algorithms/rbpf/relocalization.h"

#include <algorithm>
#include <utility>

#include <tbb/parallel_for.h>

#include "algorithms/particles/hypotheses.h"
#include "algorithms/rbpf/proposal.h"

namespace mapbed {
namespace {

std::vector<Pose2> path_of_best(const std::vector<Particle>& particles) {
  const auto best = std::max_element(
      particles.begin(), particles.end(),
      [](const Particle& a, const Particle& b) { return a.log_weight < b.log_weight; });
  return path_of(*best->history);
}

std::vector<SurfacePoint> seen_along(const std::vector<Pose2>& path,
                                     const std::vector<ScanForWeighting>& scans) {
  std::vector<SurfacePoint> points;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const std::vector<SurfacePoint> seen = transformed(scans[i].surface, path[i]);
    points.insert(points.end(), seen.begin(), seen.end());
  }
  return points;
}

std::size_t nearest_on(const std::vector<Pose2>& path, const Pose2& pose) {
  return static_cast<std::size_t>(std::min_element(path.begin(), path.end(),
                                                   [&](const Pose2& a, const Pose2& b) {
                                                     return distance(a, pose) < distance(b, pose);
                                                   }) -
                                  path.begin());
}

}  // namespace

Relocalization::Relocalization(double since, std::vector<Particle> before, const Updates& updates,
                               const RelocalizationOptions& options)
    : options_(options),
      since_(since),
      before_(std::move(before)),
      path_(path_of_best(before_)),
      search_(seen_along(path_, updates.scans), path_, options) {}

bool Relocalization::gives_up(const Updates& updates) const {
  return updates.scans.size() - first_update() >= static_cast<std::size_t>(options_.max_updates);
}

GlobalLocalizer::Answer Relocalization::find(const Updates& updates, const Pose2& here) {
  const std::size_t newest = updates.newest();
  if (newest < next_search_) return search_.look_here(updates.scans[newest].hits, here);
  GlobalLocalizer::Answer answer = searched(updates, here);
  wait_ = answer.complete ? 1 : 2 * wait_;
  next_search_ = newest + wait_;
  const std::optional<Candidate> before = candidate_;
  candidate_.reset();
  if (!answer.relocated_to) return answer;
  candidate_ = {*answer.relocated_to, newest};
  const bool confirmed =
      before && before->update + 1 == newest &&
      search_.is_same_place(
          *answer.relocated_to,
          before->map_from_robot * motion_between(updates.poses[newest - 1].seen_from_robot,
                                                  updates.poses[newest].seen_from_robot));
  if (!confirmed) answer.relocated_to.reset();
  return answer;
}

GlobalLocalizer::Answer Relocalization::searched(const Updates& updates, const Pose2& here) const {
  const std::size_t newest = updates.newest();
  const std::vector<Eigen::Vector2d>& newest_hits = updates.scans[newest].hits;
  const GlobalLocalizer::Answer alone = search_.find(newest_hits, here);
  const auto count =
      std::min(newest - first_update() + 1, static_cast<std::size_t>(options_.scans));
  if (alone.confirmed || alone.relocated_to || count == 1) return alone;
  // How several scans lie to each other is known less well where they fitted nowhere, so the newest
  // one must agree by itself.
  GlobalLocalizer::Answer together = search_.find(newest_scans(updates, count), here);
  together.complete = together.complete && alone.complete;
  if (together.relocated_to)
    together.relocated_to = search_.matched_at(*together.relocated_to, newest_hits);
  return together;
}

std::vector<Eigen::Vector2d> Relocalization::newest_scans(const Updates& updates,
                                                          std::size_t count) const {
  const std::size_t newest = updates.newest();
  std::vector<Eigen::Vector2d> points;
  for (std::size_t i = newest + 1 - count; i <= newest; ++i) {
    const Pose2 newest_from_robot =
        motion_between(updates.poses[newest].seen_from_robot, updates.poses[i].seen_from_robot);
    for (const Eigen::Vector2d& hit : updates.scans[i].hits) {
      points.push_back(newest_from_robot * hit);
    }
  }
  return points;
}

std::vector<Particle> Relocalization::restarted(const Pose2& found, const Updates& updates,
                                                const SurfaceLikelihood& likelihood,
                                                const MotionModelOptions& motion_errors,
                                                const Rng& rng) const {
  const std::size_t newest = updates.newest();
  // Maps of particles lie differently; all know the place by what they passed there.
  const std::size_t anchor = nearest_on(path_, found);
  const Pose2 anchor_from_found = motion_between(path_[anchor], found);
  std::vector<Particle> particles = before_;
  tbb::parallel_for(std::size_t{0}, particles.size(), [&](std::size_t i) {
    Particle& particle = particles[i];
    Rng own = rng.stream("found again", i, newest);
    const Pose2 start = path_of(*particle.history)[anchor] * anchor_from_found;
    // Within this the search could not tell places apart.
    const PosePrior prior = independent_prior(start, options_.rival_distance,
                                              options_.rival_distance, options_.rival_turn);
    const LocalPosterior posterior =
        likelihood.local_posterior(start, updates.scans[newest], particle.map, prior);
    particle.pose = drawn_from(posterior.mode, posterior.covariance, own);
    particle.log_weight += posterior.log_evidence;

    // Back from there to the interruption, each scan in the map of before.
    std::vector<Pose2> since(newest + 1 - first_update(), particle.pose);
    for (std::size_t k = since.size() - 1; k-- > 0;) {
      const std::size_t update = first_update() + k;
      const Pose2 back = motion_between(updates.poses[update + 1].seen_from_robot,
                                        updates.poses[update].seen_from_robot);
      const PosePrior behind = gaussian_after(since[k + 1], back, motion_errors);
      since[k] =
          likelihood.local_posterior(behind.mean, updates.scans[update], particle.map, behind).mode;
    }
    for (std::size_t k = 0; k < since.size(); ++k) {
      const std::size_t update = first_update() + k;
      if (update < newest) particle.map.add(updates.scans[update].surface, since[k]);
      particle.history = std::make_shared<HistoryNode>(since[k], update, particle.history);
    }
  });
  return particles;
}

}  // namespace mapbed
