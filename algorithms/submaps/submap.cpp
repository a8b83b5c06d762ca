#include "algorithms/submaps/submap.h"

#include "algorithms/field/local_map.h"
#include "core/check.h"

namespace mapbed {

std::vector<PointMotion> robots_from(const Submap& submap) {
  std::vector<PointMotion> robots_from_submap;
  for (const Pose2& pose : submap.path) robots_from_submap.emplace_back(inverse(pose));
  return robots_from_submap;
}

Seen seen_in(const Submap& submap, const std::vector<PointMotion>& robots_from_submap,
             const Eigen::Vector2d& point) {
  constexpr double kMargin = 0.3;  // [m]
  Seen seen = Seen::nothing;
  for (std::size_t i = 0; i < submap.extents.size(); ++i) {
    const Seen by_scan = submap.extents[i].at(robots_from_submap[i] * point, kMargin);
    if (by_scan == Seen::free) return by_scan;
    if (by_scan == Seen::surface) seen = by_scan;
  }
  return seen;
}

Submap make_submap(const std::vector<SubmapScan>& scans, const SubmapOptions& options) {
  CHECK(!scans.empty());
  Submap submap;
  SurfaceMeans means(options.resolution);
  for (const SubmapScan& scan : scans) {
    submap.path.push_back(scan.submap_from_robot);
    submap.extents.push_back(scan.extent);
    means.add(transformed(scan.surface, scan.submap_from_robot));
  }
  submap.surface = means.means();
  return submap;
}

SubmapField make_field(const Submap& submap, const SubmapOptions& options, double window) {
  SubmapField made{
      .field = LikelihoodField({.resolution = options.resolution, .sigma = options.sigma}),
      .pyramid = {}};
  made.field.add(submap.surface);
  made.pyramid = make_bound_pyramid(made.field, window);
  return made;
}

}  // namespace mapbed
