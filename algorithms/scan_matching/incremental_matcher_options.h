#pragma once

#include "algorithms/field/likelihood_field.h"
#include "algorithms/field/local_map.h"
#include "algorithms/motion/motion_prior.h"
#include "algorithms/scan/hit_points.h"
#include "algorithms/scan_matching/correlative_matcher.h"
#include "algorithms/scan_matching/icp_matcher.h"
#include "algorithms/scan_matching/scan_matcher.h"
#include "core/config/option.h"

namespace mapbed {

// How a scan is aligned with the local map.
enum class Alignment : int { hill_climbing, correlative, icp };

struct IncrementalMatcherOptions {
  Alignment alignment = Alignment::hill_climbing;
  bool use_odometry = true;   // false: predict from the last motion alone, as where a log has none
  double search_below = 0.7;  // a climb that explains less of the scan is checked by a search
  bool weigh_footprints = false;  // footprint_weights.h
  HitPointOptions points;
  LocalMapOptions local_map;
  LikelihoodFieldOptions field;
  MotionPriorOptions motion;
  ScanMatcherOptions climb;
  CorrelativeMatcherOptions search;
  CorrelativeMatcherOptions wide_search{
      .window = 1.0, .turn_window = 3.15, .min_inlier_ratio = 0.65};
  IcpMatcherOptions icp;
};

template <class Visitor>
void visit_fields(IncrementalMatcherOptions& o, Visitor&& visit) {
  visit("alignment", o.alignment, {"hill_climbing", "correlative", "icp"},
        "how a scan is aligned with the local map");
  visit("use_odometry", o.use_odometry, "false: predict from the last motion alone");
  visit("search_below", o.search_below, kFraction,
        "hill climbing that explains a smaller fraction of the scan is checked by a search");
  visit("weigh_footprints", o.weigh_footprints,
        "a hit counts by how exactly its beam tells where it is, across the beam: less far off, "
        "where "
        "the surface is aslant or unknown");
  visit("points", o.points, "which points of a scan are matched");
  visit("local_map", o.local_map, "which past scans are matched against");
  visit("field", o.field, "the smoothed local map");
  visit("motion", o.motion, "what the prediction is worth");
  visit("climb", o.climb, "hill climbing");
  visit("search", o.search, "correlative search");
  visit("wide_search", o.wide_search,
        "search without regard to the prediction, after an untrusted match");
  visit("icp", o.icp, "point-to-line ICP");
}

}  // namespace mapbed
