#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "algorithms/association_tree.h"
#include "algorithms/grid/occupancy_map.h"
#include "algorithms/pose_graph/pose_graph.h"
#include "algorithms/remark.h"
#include "algorithms/tag_belief.h"
#include "core/config/unit.h"
#include "core/geometry/trajectory.h"
#include "core/labels/beam_labels.h"
#include "core/labels/tracks.h"
#include "core/sensor/measurement.h"
#include "core/time_interval.h"

namespace mapbed {

// A value that a method has at each of its iterations.
struct IterationValues {
  std::string name;  // "log_likelihood"
  Unit unit = Unit::none;
  std::vector<double> values;  // by iteration, from the first
};

// What a method believes at some point in time.
struct Estimate {
  // map_from_robot at the stamp of every scan that the method takes in, in order: methods in the
  // plane leave out lasers that are not level.
  Trajectory trajectory;
  // Of methods that tell how sure they are: of each pose's x, y [m] and theta [rad] in the map.
  std::vector<Eigen::Matrix3d> covariances = {};
  // Where the robot was lost: the poses then do not lie right to those before.
  std::vector<TimeInterval> lost = {};
  // Scans whose pose is the prediction alone: the match was not trustworthy.
  int untrusted_scans = 0;
  // What the user should know ("no odometry from 12.3 s to 22.4 s").
  std::vector<Remark> remarks = {};
  // Of methods that tell what moves: one for each pose of the trajectory. Maps leave out what
  // dynamic beams met.
  std::optional<BeamLabels> labels = {};
  // Of methods that follow what moves, in the frame of the map.
  std::optional<Tracks> tracks = {};
  std::vector<IterationValues> iterations = {};  // of methods that iterate
  // Of methods that have one: the path's nodes, with all constraints that are believed.
  std::optional<PoseGraph<Pose2>> graph = {};
  std::optional<AssociationTree> associations = {};  // of methods that search them
  std::vector<TagBelief> tags = {};                  // of methods that map them
};

// Labels for build_map(); none where the method gives none.
inline std::span<const ScanLabels> labels_in(const Estimate& estimate) {
  return estimate.labels ? std::span<const ScanLabels>(*estimate.labels)
                         : std::span<const ScanLabels>();
}

// How many possibilities a particle filter still holds, at one of its updates.
struct Diversity {
  double time = 0.0;              // [s]
  int distinct_ancestors = 0;     // of today's particles among those of that update
  double effective_number = 0.0;  // after weighting, before resampling
  bool resampled = false;
};

// What a method with several hypotheses holds besides its estimate; empty for all others.
struct Hypotheses {
  // map_from_robot of all paths that are held possible. What several have in common stands there
  // once: each branch begins where it parted from one before it.
  std::vector<Trajectory> branches;
  std::vector<Diversity> diversity;  // at each update so far
};

// What a method may be told beforehand.
struct Given {
  std::optional<Pose2> start = {};  // map_from_robot at the first scan; else the map begins there
  std::shared_ptr<const OccupancyMap> map = {};  // of the place, for methods that make none
  std::vector<TagBelief> tags = {};              // where RFID tags are, in the frame of that map
  std::vector<Pose2> near = {};  // map_from_robot: it starts by one of these; empty: anywhere
};

// The one interface behind which methods are exchanged: measurements in, belief out, at any time.
class Estimator {
 public:
  virtual ~Estimator() = default;

  // In order of time. `beam_weights`, in [0, 1], one for each beam of a scan, say how much the
  // method shall believe of it: 0 is a beam that failed, less than 1 scales its term in likelihoods
  // (maps take it in whole). Empty: all count fully.
  virtual void add(const Measurement& measurement, std::span<const float> beam_weights = {}) = 0;

  // Once, before the last estimate(): what a method does with all measurements together.
  virtual void finish() {}

  virtual Pose2 pose() const = 0;         // map_from_robot now; cheap
  virtual Estimate estimate() const = 0;  // the whole path, as it is believed now

  // For pictures on the way, where a whole estimate would cost too much: its trajectory without
  // what is left for the end, as refinement is, and what else is held possible.
  virtual Trajectory path_so_far() const { return estimate().trajectory; }
  virtual Hypotheses hypotheses() const { return {}; }
};

}  // namespace mapbed
