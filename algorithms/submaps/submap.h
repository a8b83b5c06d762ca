#pragma once

#include <memory>
#include <vector>

#include "algorithms/field/bound_pyramid.h"
#include "algorithms/field/likelihood_field.h"
#include "algorithms/scan/surface_points.h"
#include "algorithms/submaps/point_motion.h"
#include "algorithms/submaps/scan_extent.h"
#include "core/config/option.h"
#include "core/geometry/pose2.h"

namespace mapbed {

struct SubmapOptions {
  int keyframes = 10;       // scans that make one
  double resolution = 0.1;  // [m] of its cells
  double sigma = 0.1;       // [m] of an end point about the mapped surface
  double max_range = 30.0;  // [m] farther hits are left out
};

template <class Visitor>
void visit_fields(SubmapOptions& o, Visitor&& visit) {
  visit("keyframes", o.keyframes, between(2, 10'000), "kept scans that make one local map");
  visit("resolution", o.resolution, Unit::meter, between(0.01, 2.0), "side of its cells");
  visit("sigma", o.sigma, Unit::meter, between(0.001, 2.0),
        "sigma of end points about the mapped surface");
  visit("max_range", o.max_range, Unit::meter, kPositive, "farther hits are left out");
}

// A scan of a local map, and where it was taken.
struct SubmapScan {
  Pose2 submap_from_robot;
  std::vector<SurfacePoint> surface;  // [m] in the robot frame
  ScanExtent extent;
};

// A piece of the path, as long as scan matching is right about it, and what was seen from there,
// section 6.3: rigid, so that where it lies is one pose. Frames are those of a scan in its middle.
struct Submap {
  std::vector<Pose2> path;            // submap_from_robot of its scans
  std::vector<ScanExtent> extents;    // of these, in their robot frames
  std::vector<SurfacePoint> surface;  // [m] in its frame, a point for each cell that was hit
};

// What its scans say of a point in its frame [m]: free where any of them looked through it, a
// surface within a margin of where beams ended. The inverses of its path are asked for, as points
// are many.
std::vector<PointMotion> robots_from(const Submap& submap);
Seen seen_in(const Submap& submap, const std::vector<PointMotion>& robots_from_submap,
             const Eigen::Vector2d& point);

Submap make_submap(const std::vector<SubmapScan>& scans, const SubmapOptions& options);

// What of a local map others are matched with. Ten times as large as the map, so that it is made
// when it is needed.
struct SubmapField {
  LikelihoodField field;
  BoundPyramid pyramid;  // for shifts of up to the window that it was made for
};
SubmapField make_field(const Submap& submap, const SubmapOptions& options, double window);

}  // namespace mapbed
