#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "algorithms/estimator.h"
#include "algorithms/rbpf/loop_closing.h"
#include "algorithms/rbpf/motion_model.h"
#include "algorithms/rbpf/particle.h"
#include "algorithms/rbpf/proposal.h"
#include "algorithms/rbpf/recovery.h"
#include "algorithms/rbpf/resampling.h"
#include "algorithms/rbpf/scan_condenser.h"
#include "algorithms/rbpf/settled_estimate.h"
#include "algorithms/rbpf/settling.h"
#include "algorithms/rbpf/surface_likelihood.h"
#include "algorithms/rbpf/surface_map.h"
#include "algorithms/rbpf/troubles.h"
#include "algorithms/scan_matching/hit_points.h"
#include "algorithms/scan_matching/incremental_matcher.h"
#include "core/config/option.h"

namespace mapbed {

struct GridSlamOptions {
  int particles = 100;
  Proposal proposal = Proposal::improved;
  double update_distance = 0.5;  // [m] of motion between updates
  double update_turn = 0.4;      // [rad] of turn between updates
  Resampling resampling = Resampling::selective;
  double resample_below = 0.5;  // effective number, as a share of the particles
  double map_resolution = 0.1;  // [m] of the particles' maps
  HitPointOptions points{.max_range = 30.0, .min_spacing = 0.1, .max_points = 90};
  SurfaceLikelihoodOptions likelihood;
  MotionModelOptions odometry_errors{.turn_noise = 0.2, .turn_per_meter = 0.15};
  MotionModelOptions matching_errors{.turn_noise = 0.03,
                                     .turn_per_meter = 0.02,
                                     .way_per_meter = 0.04,
                                     .way_per_turn = 0.02,
                                     .floor_turn = 0.004,
                                     .floor_way = 0.005};
  IncrementalMatcherOptions matcher{.local_map = {.max_scans = 40}};
  bool best_only_after_loop = false;
  LoopClosingOptions loop_closing;
  SettlingOptions settling;
  TroubleOptions troubles;
  RelocalizationOptions relocalization;
};

template <class Visitor>
void visit_fields(GridSlamOptions& o, Visitor&& visit) {
  visit("particles", o.particles, between(1, 100'000), "number of particles");
  visit("proposal", o.proposal, {"odometry", "scan_matching", "improved"},
        "where the particles of an update are drawn from");
  visit("update_distance", o.update_distance, Unit::meter, kNotNegative, "motion between updates");
  visit("update_turn", o.update_turn, Unit::radian, kNotNegative, "turn between updates");
  visit("resampling", o.resampling, {"never", "always", "selective"},
        "when particles are drawn anew");
  visit("resample_below", o.resample_below, kShare,
        "effective number of particles, as a share, below which selective resampling draws anew");
  visit("map_resolution", o.map_resolution, Unit::meter, between(0.01, 2.0),
        "cells of the particles' maps");
  visit("points", o.points, "which points of a scan weight the particles");
  visit("likelihood", o.likelihood, "how likely a scan is in a particle's map");
  visit("odometry_errors", o.odometry_errors, "errors of raw odometry");
  visit("matching_errors", o.matching_errors, "errors of the condensed motion");
  visit("matcher", o.matcher, "incremental scan matching between updates");
  visit("best_only_after_loop", o.best_only_after_loop,
        "go on with the best particle alone where a loop is closed");
  visit("loop_closing", o.loop_closing, "when a loop is closed, for best_only_after_loop");
  visit("troubles", o.troubles, "when the filter says that something is wrong");
  visit("relocalization", o.relocalization, "how a robot that was carried away finds itself again");
  visit("settling", o.settling, "what the drawing of particles left in the estimated path");
}

// Rao-Blackwellised particle filter, chapter 5: each particle is a path and the map built along it.
// Between updates scans are matched once for all particles; at an update the particles move, the
// scan weights them by its end points in their own maps (5.2), and enters those maps. Every scan of
// the log gets a pose: those between updates are matched with the map of the path that is asked
// for, between the updates about them.
//
// Where the robot may be anywhere (odometry jumped, scans were missing, the map explains nothing),
// it is looked for in the whole map, and the particles start again where it is found: recovery.h.
//
// With best_only_after_loop it is the maximum-likelihood continuation of section 5.4.2, the earlier
// way to close loops: a posterior over poses in a single map. The paths that were possible up to a
// loop are given up for the best of them as soon as the loop is closed.
class GridSlam : public Estimator {
 public:
  GridSlam(const GridSlamOptions& options, Rng rng);

  void add(const Measurement& measurement) override;
  Pose2 pose() const override;
  Estimate estimate() const override;

  Hypotheses hypotheses() const override;

  // What the particles were told of their motion from an update to the last scan before the next
  // one, by scan matching. The rest of the way is odometry's.
  struct Motion {
    double from_time = 0.0, to_time = 0.0;  // [s]
    Pose2 motion;
  };
  std::vector<Motion> motions() const;

 private:
  void add_scan(const LaserScan& scan);
  void update(const LaserScan& scan, const UpdateMotion& motion);
  void start();
  void move_and_weight(Particle& particle, const ScanForWeighting& scan, const UpdateMotion& motion,
                       Rng& rng) const;
  bool found_again(const ScanForWeighting& scan, const std::vector<double>& weights_before);
  void begin_recovery(double since, const std::vector<double>& weights_before);
  void restart_at(const Pose2& found);
  std::vector<double> log_weights() const;
  void resample_where_needed();
  bool closes_loop(const ScanForWeighting& scan);
  void keep_best_only();
  const Particle& best() const;
  std::vector<const HistoryNode*> pasts() const;
  const MotionModelOptions& motion_errors() const {
    return options_.proposal == Proposal::odometry ? options_.odometry_errors
                                                   : options_.matching_errors;
  }

  GridSlamOptions options_;
  Rng rng_;
  SurfaceLikelihood likelihood_;
  Troubles troubles_;
  ScanCondenser condenser_;
  std::vector<Particle> particles_;
  std::vector<KeptHits> hits_;                     // of each scan; none where it made an update
  std::vector<ScanForWeighting> weighting_scans_;  // of the updates
  std::vector<Diversity> updates_;                 // the ancestors are not counted
  LoopDetector loop_detector_;
  std::optional<Recovery> recovery_;  // since a trouble
  std::vector<Break> breaks_;
};

}  // namespace mapbed
