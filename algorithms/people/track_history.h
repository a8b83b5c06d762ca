#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "algorithms/people/front_end/scan_sightings.h"
#include "algorithms/people/track_life.h"
#include "core/geometry/trajectory.h"
#include "core/labels/beam_labels.h"
#include "core/labels/tracks.h"
#include "core/sensor/laser_scan.h"

namespace mapbed {

struct LabelOptions {
  double box = 0.4;     // [m]
  double margin = 0.4;  // [s]
  bool keep_place = true;
};

// Where people were, by the scans in which they were followed.
class TrackHistory {
 public:
  struct State {
    std::size_t scan = 0;
    FollowedPerson person;
  };
  using States = std::vector<State>;  // of one person, in the order in which he was followed

  // Who is not among them any more is over, and forgotten if he never counted.
  void add(std::size_t scan, const std::vector<FollowedPerson>& people);

  // Who counted in the end, up to when he was last seen: what was predicted after that led nowhere.
  // Who was somebody in the end was so from the start.
  std::vector<States> people() const;
  std::size_t states() const;  // that are kept

 private:
  std::vector<States> by_id_;
  std::vector<std::size_t> newest_;  // ids of those who were added last
};

// Section 3.3.1: what ends in somebody's bounding box is dynamic, also some time before he was
// first detected and after he was last seen, but for what is of the place (place_in_boxes.h). A
// label for each of the scans.
BeamLabels labels_of_people(const std::vector<KeptScan>& scans,
                            const std::vector<TrackHistory::States>& people,
                            const Trajectory& map_from_robot, const LabelOptions& options);

// In the frame of the path that a method found, a pose for each scan: they go with the robot.
Tracks tracks_of_people(const std::vector<KeptScan>& scans,
                        const std::vector<TrackHistory::States>& people,
                        const Trajectory& map_from_robot);

}  // namespace mapbed
