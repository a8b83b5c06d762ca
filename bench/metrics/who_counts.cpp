#include "bench/metrics/who_counts.h"

#include <algorithm>
#include <map>

#include "algorithms/people/front_end/scan_view.h"
#include "bench/metrics/true_causes.h"
#include "sim/actors/person_body.h"

namespace mapbed {
namespace {

// Beams of a scan on each entity.
std::map<int, int> beams_on_entities(const LaserScan& scan, const Truth& truth) {
  std::map<int, int> count;
  for (const ScanPart& part : parts_of(scan)) {
    const BeamTruthOfScan* beams = beams_of(truth, part.time, part.laser);
    if (beams == nullptr) continue;
    for (const BeamTruth& beam : beams->beams) {
      if (beam.entity >= 0) ++count[beam.entity];
    }
  }
  return count;
}

bool looks_towards(const ScanView& view, const Eigen::Vector2d& point_in_robot) {
  return std::any_of(view.eyes().begin(), view.eyes().end(), [&](const ScanView::Eye& eye) {
    const auto [first, end] = eye.within(eye.bearing_of(point_in_robot), eye.step);
    return first != end;
  });
}

// What is known of one person so far.
struct Appearance {
  int number = 0;
  double last_in_view = 0.0;                        // [s]
  Eigen::Vector2d start = Eigen::Vector2d::Zero();  // [m]
  bool was_in_view = false;
  bool has_moved = false;
};

}  // namespace

std::vector<TrueObject> people_at(const LaserScan& scan, const StampedStates& states,
                                  const Truth& truth, const WhoCountsOptions& options) {
  const std::map<int, int> beams = beams_on_entities(scan, truth);
  const ScanView view(scan);
  const Pose2 robot_from_world = inverse(states.world_from_robot);
  std::vector<TrueObject> people;
  for (const MovingPose& part : states.moving) {
    const TruthEntity& entity = truth.entities[static_cast<std::size_t>(part.entity)];
    if (entity.kind != EntityKind::person || part.part != kTrunk) continue;
    const Eigen::Vector2d position = part.world_from_part.position.head<2>();
    const bool is_near = (position - states.world_from_robot.position()).norm() <= options.range;
    const auto on_him = beams.find(entity.id);
    const bool is_seen = on_him != beams.end() && on_him->second >= options.least_beams;
    people.push_back(
        {.id = entity.id,
         .position = position,
         .counts = is_near && is_seen,
         .is_hidden = is_near && !is_seen && looks_towards(view, robot_from_world * position)});
  }
  return people;
}

TrackingFrames by_appearance(TrackingFrames frames, const WhoCountsOptions& options) {
  std::map<int, Appearance> appearances;
  int next_number = 0;
  for (TrackingFrame& frame : frames) {
    for (TrueObject& object : frame.truth) {
      const auto [found, is_first] = appearances.try_emplace(object.id);
      Appearance& of = found->second;
      if (is_first) of.number = next_number++;
      if (object.counts) {
        if (of.was_in_view && frame.time - of.last_in_view > options.longest_absence) {
          of = {.number = next_number++};
        }
        if (!of.was_in_view) of.start = object.position;
        of.was_in_view = true;
        of.last_in_view = frame.time;
        of.has_moved = of.has_moved || (object.position - of.start).norm() > options.least_move;
      }
      object.id = of.number;
      object.has_moved = of.has_moved;
      object.counts = object.counts && of.has_moved;
    }
  }
  return frames;
}

}  // namespace mapbed
