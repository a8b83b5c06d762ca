#include "algorithms/people/track_history.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "algorithms/people/place_in_boxes.h"
#include "core/check.h"

namespace mapbed {
namespace {

constexpr float kOnSomebody = 0.05F;  // probability that it is static: a box holds a wall at times
constexpr float kElsewhere = 0.95F;   // somebody may stand there whom nobody saw move
constexpr double kMostSpread = 0.3;   // [m] by which a box is larger: beyond, it says little

struct Box {
  Eigen::Vector2d centre;
  Eigen::Vector2d half;

  bool holds(const Eigen::Vector2d& point) const {
    return ((point - centre).cwiseAbs().array() <= half.array()).all();
  }
};

Eigen::Matrix2d rotation_of(const Pose2& pose) {
  const double c = std::cos(pose.theta);
  const double s = std::sin(pose.theta);
  return (Eigen::Matrix2d() << c, -s, s, c).finished();
}

// Where he was in each scan; within the margin of the first and of the last one as he walked.
void add_boxes(const TrackHistory::States& states, const std::vector<KeptScan>& scans,
               const LabelOptions& options, std::vector<std::vector<Box>>& boxes) {
  const auto add = [&](const TrackHistory::State& state, std::size_t k) {
    const FollowedPerson& person = state.person;
    const double later = scans[k].time() - scans[state.scan].time();
    if (std::abs(later) > options.margin) return false;
    const Eigen::Vector2d spread = person.covariance.diagonal().cwiseSqrt().cwiseMin(kMostSpread);
    boxes[k].push_back({person.position + later * person.velocity,
                        Eigen::Vector2d::Constant(options.box) + spread});
    return true;
  };
  for (const TrackHistory::State& state : states) add(state, state.scan);
  for (const TrackHistory::State* end : {&states.front(), &states.back()}) {
    for (std::size_t k = end->scan; k-- > 0 && add(*end, k);) {
    }
    for (std::size_t k = end->scan + 1; k < scans.size() && add(*end, k); ++k) {
    }
  }
}

}  // namespace

void TrackHistory::add(std::size_t scan, const std::vector<FollowedPerson>& people) {
  std::vector<std::size_t> ids;
  for (const FollowedPerson& person : people) {
    const auto id = static_cast<std::size_t>(person.id);
    if (by_id_.size() <= id) by_id_.resize(id + 1);
    by_id_[id].push_back({scan, person});
    ids.push_back(id);
  }
  for (const std::size_t id : newest_) {
    const bool goes_on = std::find(ids.begin(), ids.end(), id) != ids.end();
    if (!goes_on && !by_id_[id].back().person.is_confirmed) by_id_[id] = {};
  }
  newest_ = std::move(ids);
}

std::size_t TrackHistory::states() const {
  std::size_t count = 0;
  for (const States& states : by_id_) count += states.size();
  return count;
}

std::vector<TrackHistory::States> TrackHistory::people() const {
  std::vector<States> people;
  for (const States& states : by_id_) {
    States kept = states;
    while (!kept.empty() && !kept.back().person.is_seen) kept.pop_back();
    if (!kept.empty() && kept.back().person.is_confirmed) people.push_back(std::move(kept));
  }
  return people;
}

BeamLabels labels_of_people(const std::vector<KeptScan>& scans,
                            const std::vector<TrackHistory::States>& people,
                            const Trajectory& map_from_robot, const LabelOptions& options) {
  std::vector<std::vector<Box>> boxes(scans.size());
  for (const TrackHistory::States& states : people) add_boxes(states, scans, options, boxes);
  BeamLabels labels;
  labels.reserve(scans.size());
  for (std::size_t k = 0; k < scans.size(); ++k) {
    const LaserScan& scan = scans[k].readings;
    ScanLabels& of_scan = labels.emplace_back(unlabelled(scan));
    for (std::size_t b = 0; b < scan.ranges.size(); ++b) {
      if (!scan.is_hit(b)) continue;
      const Eigen::Vector2d end = scans[k].local_from_robot * scan.point_on(b, scan.ranges[b]);
      const bool is_on_somebody = std::any_of(boxes[k].begin(), boxes[k].end(),
                                              [&](const Box& box) { return box.holds(end); });
      of_scan.static_probability[b] = is_on_somebody ? kOnSomebody : kElsewhere;
    }
  }
  if (options.keep_place) keep_the_place(scans, map_from_robot, kElsewhere, labels);
  return labels;
}

Tracks tracks_of_people(const std::vector<KeptScan>& scans,
                        const std::vector<TrackHistory::States>& people,
                        const Trajectory& map_from_robot) {
  CHECK(map_from_robot.size() == scans.size());
  Tracks tracks;
  for (const TrackHistory::States& states : people) {
    ObjectTrack& track = tracks.emplace_back();
    track.id = states.front().person.id;
    for (const TrackHistory::State& state : states) {
      const KeptScan& scan = scans[state.scan];
      const Pose2 map_from_local = map_from_robot[state.scan].pose * inverse(scan.local_from_robot);
      const Eigen::Matrix2d turn = rotation_of(map_from_local);
      const FollowedPerson& person = state.person;
      track.states.push_back({scan.time(), map_from_local * person.position, turn * person.velocity,
                              turn * person.covariance * turn.transpose(), !person.is_seen});
    }
  }
  return tracks;
}

}  // namespace mapbed
