#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "algorithms/estimator.h"
#include "algorithms/field/surface_likelihood.h"
#include "algorithms/field/surface_map.h"
#include "algorithms/rbpf/front_end.h"
#include "algorithms/rbpf/grid_slam_options.h"
#include "algorithms/rbpf/input_diagnostics.h"
#include "algorithms/rbpf/loop_closing.h"
#include "algorithms/rbpf/particle.h"
#include "algorithms/rbpf/relocalization.h"
#include "algorithms/refinement/trajectory_refinement.h"
#include "algorithms/scan/level_lasers.h"

namespace mapbed {

// Rao-Blackwellised particle filter, chapter 5: each particle is a path and the map built along it.
// Between updates scans are matched once for all particles; at an update the particles move, the
// scan weights them by its end points in their own maps (5.2); it enters those maps with the update
// after. Every scan of the log gets a pose: those between updates are carried from the updates
// about them. With refinement.enabled the path that is asked for is refined, and they are matched
// with its map.
//
// Where the robot may be anywhere (odometry jumped, scans were missing, the map explains nothing),
// it is looked for in the whole map, and the particles start again where it is found: recovery.h.
//
// With best_only_after_loop it is the maximum-likelihood continuation of section 5.4.2, the earlier
// way to close loops: a posterior over poses in a single map. The paths that were possible up to a
// loop are given up for the best of them as soon as the loop is closed.
class GridSlam : public Estimator {
 public:
  // `start` is map_from_robot at the first scan.
  GridSlam(const GridSlamOptions& options, Rng rng, const Pose2& start = {});

  void add(const Measurement& measurement, std::span<const float> beam_weights = {}) override;
  Pose2 pose() const override;
  Estimate estimate() const override;

  Trajectory path_so_far() const override;
  Hypotheses hypotheses() const override;

  // What the particles were told of their motion from an update to the last scan before the next
  // one, by scan matching. The rest is odometry's.
  struct Motion {
    double from_time = 0.0, to_time = 0.0;  // [s]
    Pose2 motion;
  };
  std::vector<Motion> motions() const;

 private:
  void add_scan(const LaserScan& scan, std::span<const float> beam_weights);
  void update(const LaserScan& scan, std::span<const float> beam_weights,
              const UpdateMotion& motion);
  void start();
  PosePrior prior_of(const Particle& particle, const UpdateMotion& motion) const;
  std::optional<Pose2> other_guess(const ScanForWeighting& scan, const ScanForWeighting& before,
                                   const UpdateMotion& motion) const;
  void move_and_weight(Particle& particle, const ScanForWeighting& scan, const UpdateMotion& motion,
                       Rng& rng) const;
  bool relocalized(const ScanForWeighting& scan, const std::vector<double>& weights_before);
  void begin_relocalization(double since, const std::vector<double>& weights_before);
  void restart_at(const Pose2& found);
  std::vector<double> log_weights() const;
  void resample_where_needed();
  bool closes_loop(const ScanForWeighting& scan);
  void keep_best_only();
  const Particle& best() const;
  std::vector<const HistoryNode*> pasts() const;
  Track track() const;
  const MotionModelOptions& motion_errors() const {
    return options_.proposal == Proposal::odometry ? options_.odometry_errors
                                                   : options_.matching_errors;
  }

  GridSlamOptions options_;
  Rng rng_;
  Pose2 start_;
  SurfaceLikelihood likelihood_;
  LevelLasers lasers_;
  InputDiagnostics diagnostics_;
  FrontEnd front_end_;
  std::vector<Particle> particles_;
  std::vector<KeptHits> hits_;                     // for refinement, of each scan but updates
  std::vector<ScanForWeighting> weighting_scans_;  // of the updates
  std::vector<Diversity> updates_;                 // the ancestors are not counted
  LoopDetector loop_detector_;
  std::optional<Relocalization> relocalization_;  // since an interruption
  std::vector<Track::Break> breaks_;
};

}  // namespace mapbed
