#pragma once

#include "algorithms/field/surface_likelihood.h"
#include "algorithms/localization/global_localizer.h"
#include "algorithms/motion/motion_model.h"
#include "algorithms/particles/resampling.h"
#include "algorithms/rbpf/input_diagnostics.h"
#include "algorithms/rbpf/loop_closing.h"
#include "algorithms/rbpf/proposal.h"
#include "algorithms/refinement/trajectory_refinement.h"
#include "algorithms/scan/beam.h"
#include "algorithms/scan/hit_points.h"
#include "algorithms/scan_matching/incremental_matcher.h"
#include "core/config/option.h"

namespace mapbed {

struct GridSlamOptions {
  int particles = 100;
  Proposal proposal = Proposal::improved;
  double update_distance = 0.5;  // [m] of motion between updates
  double update_turn = 0.4;      // [rad] of turn between updates
  Resampling resampling = Resampling::selective;
  double resample_below = 0.5;  // effective number, as a fraction of the particles
  double map_resolution = 0.1;  // [m] of the particles' maps
  HitPointOptions points{.max_range = 30.0, .min_spacing = 0.1, .max_points = 90};
  SurfaceLikelihoodOptions likelihood;
  MotionModelOptions odometry_errors{.rotation_per_rotation = 0.2, .rotation_per_meter = 0.15};
  MotionModelOptions matching_errors{.rotation_per_rotation = 0.03,
                                     .rotation_per_meter = 0.02,
                                     .translation_per_meter = 0.04,
                                     .translation_per_rotation = 0.02,
                                     .least_rotation_sigma = 0.004,
                                     .least_translation_sigma = 0.005};
  // It sees as far as maps do. Single far hits down a corridor shall not decide where the robot is;
  // scan matching alone is better off without that where odometry errs much.
  IncrementalMatcherOptions matcher{.weigh_footprints = true,
                                    .points = {.max_range = BeamLimits{}.usable_range},
                                    .local_map = {.max_scans = 40}};
  bool best_only_after_loop = false;
  LoopClosingOptions loop_closing;
  RefinementOptions refinement;
  InputDiagnosticsOptions input_diagnostics;
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
  visit(
      "resample_below", o.resample_below, kFraction,
      "effective number of particles, as a fraction, below which selective resampling draws anew");
  visit("map_resolution", o.map_resolution, Unit::meter, between(0.01, 2.0),
        "cells of the particles' maps");
  visit("points", o.points, "which points of a scan weight the particles");
  visit("likelihood", o.likelihood, "how likely a scan is in a particle's map");
  visit("odometry_errors", o.odometry_errors, "errors of raw odometry");
  visit("matching_errors", o.matching_errors, "errors of the condensed motion");
  // The rest of the matcher is as the method scan_matching has it by default.
  visit("matcher.alignment", o.matcher.alignment, {"hill_climbing", "correlative", "icp"},
        "how a scan between updates is aligned with the local map");
  visit("matcher.use_odometry", o.matcher.use_odometry,
        "false: predict from the last motion alone");
  visit("matcher.local_map", o.matcher.local_map, "which past scans are matched against");
  visit("best_only_after_loop", o.best_only_after_loop,
        "go on with the best particle alone where a loop is closed");
  visit("loop_closing", o.loop_closing, "when a loop is closed, for best_only_after_loop");
  visit("input_diagnostics", o.input_diagnostics, "when the filter says that something is wrong");
  visit("relocalization", o.relocalization, "how a robot that was carried away finds itself again");
  visit("refinement", o.refinement, "what the drawing of particles left in the estimated path");
}

}  // namespace mapbed
