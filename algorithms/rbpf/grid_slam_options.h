#pragma once

#include "algorithms/field/surface_likelihood.h"
#include "algorithms/localization/relocalization.h"
#include "algorithms/motion/motion_model.h"
#include "algorithms/particles/resampling.h"
#include "algorithms/rbpf/loop_closing.h"
#include "algorithms/rbpf/proposal.h"
#include "algorithms/rbpf/troubles.h"
#include "algorithms/refinement/trajectory_refinement.h"
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
  RefinementOptions refinement;
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
  visit("refinement", o.refinement, "what the drawing of particles left in the estimated path");
}

}  // namespace mapbed
