#include "algorithms/segments/segment_filter.h"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "algorithms/people/front_end/people_front_end.h"
#include "algorithms/scan/beam_weights.h"

namespace mapbed {
namespace {

constexpr float kOnAMover = 0.05F;   // probability that it is static
constexpr float kElsewhere = 0.95F;  // something may stand there that nobody saw move

std::set<int> ids_of(const std::vector<TrackHistory::States>& things) {
  std::set<int> ids;
  for (const TrackHistory::States& states : things) ids.insert(states.front().person.id);
  return ids;
}

void label(const std::vector<std::vector<SegmentTracker::Met>>& met, const std::set<int>& movers,
           BeamLabels& labels) {
  for (std::size_t k = 0; k < met.size(); ++k) {
    for (const SegmentTracker::Met& on : met[k]) {
      if (movers.contains(on.id)) labels[k].static_probability[on.beam] = kOnAMover;
    }
  }
}

std::vector<bool> on_movers(const std::vector<SegmentTracker::Met>& met, std::size_t beams) {
  std::vector<bool> result(beams, false);
  for (const SegmentTracker::Met& on : met) {
    if (on.is_confirmed) result[on.beam] = true;
  }
  return result;
}

}  // namespace

// Before the scan is aligned: what ends in the box of something that moves.
std::vector<float> SegmentFilter::expected_weights(const LaserScan& scan) const {
  std::vector<float> weights(scan.ranges.size(), 1.0F);
  const std::vector<Eigen::AlignedBox2d> boxes = tracker_.boxes();
  if (boxes.empty()) return weights;
  const Pose2 local_from_robot = frame_.predicted(scan.time);
  for (std::size_t b = 0; b < weights.size(); ++b) {
    if (!scan.is_hit(b)) continue;
    const Eigen::Vector2d end = local_from_robot * scan.point_on(b, scan.ranges[b]);
    const bool is_in_one =
        std::any_of(boxes.begin(), boxes.end(), [&](const auto& box) { return box.contains(end); });
    if (is_in_one) weights[b] = 0.0F;
  }
  return weights;
}

std::vector<float> SegmentFilter::add(const LaserScan& scan, std::span<const float> beam_weights) {
  const LaserScan believed = beam_weights.empty() ? scan : with_failed_beams(scan, beam_weights);
  tracker_.predict(scan.time);
  std::vector<float> weights = expected_weights(believed);
  for (std::size_t b = 0; b < beam_weights.size(); ++b) weights[b] *= beam_weights[b];
  const ScanView view(believed);
  const Pose2 local_from_robot = frame_.add(believed, weights);
  scans_.push_back({view.scan(), local_from_robot});
  tracker_.update(
      {view, local_from_robot, segments_of(view, local_from_robot, recent_, options_.segments)});
  met_.push_back(tracker_.met());
  history_.add(scans_.size() - 1, tracker_.followed());

  const std::vector<bool> on_mover = on_movers(met_.back(), scan.ranges.size());
  recent_.add(view, local_from_robot, on_mover);
  for (std::size_t b = 0; b < weights.size(); ++b) weights[b] = on_mover[b] ? 0.0F : 1.0F;
  return weights;
}

// The same scans again, the last one first, by a clock that runs backwards.
void SegmentFilter::label_back(BeamLabels& labels) const {
  SegmentTracker tracker(options_.tracker);
  RecentScans later(options_.recent);
  TrackHistory history;
  std::vector<MetInScan> met(scans_.size());
  for (std::size_t k = scans_.size(); k-- > 0;) {
    const ScanSightings scan = mirrored_in_time(scans_[k]);
    tracker.predict(scan.time());
    tracker.update({scan.view, scan.local_from_robot,
                    segments_of(scan.view, scan.local_from_robot, later, options_.segments)});
    met[k] = tracker.met();
    history.add(k, tracker.followed());
    later.add(scan.view, scan.local_from_robot, on_movers(met[k], scan.view.scan().ranges.size()));
  }
  label(met, ids_of(history.people()), labels);
}

FilterResult SegmentFilter::result(const Trajectory& map_from_robot) const {
  FilterResult result;
  for (const KeptScan& scan : scans_) {
    const LaserScan& readings = scan.readings;
    ScanLabels& of_scan = result.labels.emplace_back(unlabelled(readings));
    for (std::size_t b = 0; b < readings.ranges.size(); ++b) {
      if (readings.is_hit(b)) of_scan.static_probability[b] = kElsewhere;
    }
  }
  const std::vector<TrackHistory::States> things = history_.people();
  label(met_, ids_of(things), result.labels);
  if (options_.follow_back) label_back(result.labels);
  result.tracks = tracks_of_people(scans_, things, map_from_robot);
  result.remarks.push_back(
      {RemarkKind::note, fmt::format("segments: {} {} of what moved", things.size(),
                                     things.size() == 1 ? "track" : "tracks")});
  return result;
}

}  // namespace mapbed
