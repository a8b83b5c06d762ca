#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "algorithms/field/surface_likelihood.h"
#include "algorithms/localization/global_localizer.h"
#include "algorithms/motion/motion_model.h"
#include "algorithms/rbpf/front_end.h"
#include "algorithms/rbpf/particle.h"
#include "core/random.h"

namespace mapbed {

// The filter's memory of how it was before an interruption after which the robot may be anywhere:
// carried away, driven on without scans, lost. Meanwhile the filter goes on as it can. Where the
// robot is found in the map of before, the particles start again from there, each in its own map of
// before, and what was seen since the interruption enters at the places that follow, not where it
// was put meanwhile.
class Relocalization {
 public:
  // What the filter knows of all its updates.
  struct Updates {
    const std::vector<ScanForWeighting>& scans;
    const std::vector<FrontEnd::Update>& poses;
    std::size_t newest() const { return scans.size() - 1; }
  };

  // `before` as they were when the last scan before the interruption had entered their maps.
  Relocalization(double since, std::vector<Particle> before, const Updates& updates,
                 const RelocalizationOptions& options);

  double since() const { return since_; }                    // [s]
  std::size_t first_update() const { return path_.size(); }  // after the interruption
  bool gives_up(const Updates& updates) const;

  // Where the robot is with the newest update. Elsewhere only where the search after the update
  // before led to the same place: what looks alike by chance does so once. Where nothing stands out
  // and a search is given up, as among trees, the next one waits for twice as many updates.
  GlobalLocalizer::Answer find(const Updates& updates, const Pose2& here);

  // The particles after the newest update, made where the robot was found.
  std::vector<Particle> restarted(const Pose2& found, const Updates& updates,
                                  const SurfaceLikelihood& likelihood,
                                  const MotionModelOptions& motion_errors, const Rng& rng) const;

 private:
  GlobalLocalizer::Answer searched(const Updates& updates, const Pose2& here) const;
  // In the newest one's robot frame [m].
  std::vector<Eigen::Vector2d> newest_scans(const Updates& updates, std::size_t count) const;

  RelocalizationOptions options_;
  double since_;
  std::vector<Particle> before_;
  std::vector<Pose2> path_;  // of the best of them, by update
  GlobalLocalizer search_;   // in its map
  struct Candidate {
    Pose2 map_from_robot;
    std::size_t update = 0;
  };
  std::optional<Candidate> candidate_;
  std::size_t next_search_ = 0;  // update
  std::size_t wait_ = 1;         // [updates] after a search that was given up
};

}  // namespace mapbed
