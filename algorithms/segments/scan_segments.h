#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "algorithms/people/front_end/moved_features.h"
#include "algorithms/people/front_end/scan_view.h"
#include "core/config/option.h"
#include "core/geometry/pose2.h"

namespace mapbed {

struct ScanSegmentOptions {
  double jump = 0.25;       // [m]
  double radius = 0.05;     // [m]
  double max_range = 15.0;  // [m]
};

template <class Visitor>
void visit_fields(ScanSegmentOptions& o, Visitor&& visit) {
  visit("jump", o.jump, Unit::meter, between(0.01, 5.0),
        "between ends of neighbouring beams, their spacing apart, at which one thing ends and "
        "another begins");
  visit("radius", o.radius, Unit::meter, between(0.01, 1.0),
        "about the end of a beam, in which past scans are asked what stood there");
  visit("max_range", o.max_range, Unit::meter, between(0.1, 200.0), "where nothing is looked for");
}

// Beams of one laser that follow each other along one thing.
struct ScanSegment {
  int piece = 0;                            // the same where ranges do not jump in between
  std::vector<std::size_t> beams;           // of the scan
  Eigen::AlignedBox2d box;                  // [m] of their ends, in the local frame
  SeenBefore before = SeenBefore::nothing;  // what most of its beams say
};

// A scan cut into segments, where ranges jump and where what stood there before (`past`) ends: a
// wall and who leans on it are two things. Nothing else is known of what they are.
std::vector<ScanSegment> segments_of(const ScanView& view, const Pose2& local_from_robot,
                                     const RecentScans& past, const ScanSegmentOptions& options);

}  // namespace mapbed
