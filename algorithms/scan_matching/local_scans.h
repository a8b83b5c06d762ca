#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "algorithms/field/bound_pyramid.h"
#include "algorithms/field/likelihood_field.h"
#include "algorithms/field/local_map.h"
#include "algorithms/field/observed_ground.h"
#include "algorithms/scan/surface_points.h"
#include "algorithms/scan_matching/icp_matcher.h"
#include "core/sensor/laser_scan.h"

namespace mapbed {

// What scans are matched with: the newest scans that were far enough from each other (Algorithm 1),
// as the field of their surfaces, and the ground that they looked over. Memory is bounded by the
// options and by what one scan sees.
class LocalScans {
 public:
  // Hits beyond max_range [m] are left out.
  LocalScans(const LocalMapOptions& local_map, const LikelihoodFieldOptions& field,
             double max_range);

  bool empty() const { return poses_.empty(); }

  // Keeps the scan where it is far enough from the one kept before, and brings the field up to
  // date: as all kept scans are that far from each other, it is made of the newest of them. In
  // between it stays as it is: Algorithm 1 would only exchange its newest scan.
  void remember(const LaserScan& scan, const Pose2& map_from_robot);
  void forget_past(bool keep_newest);

  const LikelihoodField& field() const { return field_; }
  // Those of some hits [m in the robot frame] of a laser that say something about the pose, where
  // the robot is predicted: which these are must be decided once. Judged anew at each pose that is
  // tried, a hit would gain by leaving the ground that is known.
  std::vector<bool> known(const std::vector<Eigen::Vector2d>& hits, const Pose2& robot_from_laser,
                          const Pose2& predicted) const;
  const BoundPyramid& pyramid(double window);  // of the field, made when first needed
  const IcpMap& icp_map();                     // the same for ICP

 private:
  void forget_oldest(std::size_t count);
  void forget_surfaces(std::size_t count);  // and brings the field up to date
  void forget_ground(std::size_t count);
  void forget_poses(std::size_t count);

  LocalMapOptions options_;
  double max_range_;
  std::vector<Pose2> poses_;                      // map_from_robot, oldest first
  std::deque<std::vector<SurfacePoint>> points_;  // [m] in the map frame
  std::deque<ObservedGround::Outline> outlines_;
  ObservedGround ground_;
  SurfaceMeans means_;
  LikelihoodField field_;
  BoundPyramid pyramid_;
  bool pyramid_is_current_ = false;
  std::optional<IcpMap> icp_map_;
};

}  // namespace mapbed
