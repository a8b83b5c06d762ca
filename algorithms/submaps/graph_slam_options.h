#pragma once

#include "algorithms/field/surface_likelihood.h"
#include "algorithms/motion/motion_model.h"
#include "algorithms/refinement/trajectory_refinement.h"
#include "algorithms/scan/beam.h"
#include "algorithms/scan/hit_points.h"
#include "algorithms/scan_matching/incremental_matcher_options.h"
#include "algorithms/submaps/loop_closer.h"
#include "core/config/option.h"

namespace mapbed {

struct GraphSlamOptions {
  double node_distance = 0.5;   // [m] of motion between nodes
  double node_turn = 0.4;       // [rad] of turn between nodes
  double map_resolution = 0.1;  // [m] of the surfaces that are kept
  HitPointOptions points{.max_range = 30.0, .min_spacing = 0.1, .max_points = 90};
  MotionModelOptions odometry_errors{.rotation_per_rotation = 0.2, .rotation_per_meter = 0.15};
  MotionModelOptions matching_errors{.rotation_per_rotation = 0.02,
                                     .rotation_per_meter = 0.01,
                                     .translation_per_meter = 0.02,
                                     .translation_per_rotation = 0.015,
                                     .least_rotation_sigma = 0.002,
                                     .least_translation_sigma = 0.004};
  IncrementalMatcherOptions matcher{.weigh_footprints = true,
                                    .points = {.max_range = BeamLimits{}.usable_range},
                                    .local_map = {.max_scans = 40}};
  LoopCloserOptions loops;
  RefinementOptions refinement{.enabled = true};
};

template <class Visitor>
void visit_fields(GraphSlamOptions& o, Visitor&& visit) {
  visit("node_distance", o.node_distance, Unit::meter, kNotNegative, "motion between nodes");
  visit("node_turn", o.node_turn, Unit::radian, kNotNegative, "turn between nodes");
  visit("map_resolution", o.map_resolution, Unit::meter, between(0.01, 2.0),
        "of the surfaces that nodes keep");
  visit("points", o.points, "which points of a scan are refined");
  visit("odometry_errors", o.odometry_errors, "errors of raw odometry");
  visit("matching_errors", o.matching_errors, "errors of scan matching from node to node");
  visit("matcher", o.matcher, "scan matching between nodes");
  visit("loops", o.loops, "how places that were seen before are found");
  visit("refinement", o.refinement, "all scans of the path together");
}

}  // namespace mapbed
