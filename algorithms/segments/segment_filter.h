#pragma once

#include <vector>

#include "algorithms/beam_filter.h"
#include "algorithms/people/front_end/local_frame.h"
#include "algorithms/people/track_history.h"
#include "algorithms/segments/segment_tracker.h"
#include "core/config/option.h"

namespace mapbed {

struct SegmentFilterOptions {
  bool follow_back = true;
  RecentScansOptions recent;
  ScanSegmentOptions segments;
  SegmentTrackerOptions tracker;
};

template <class Visitor>
void visit_fields(SegmentFilterOptions& o, Visitor&& visit) {
  visit("follow_back", o.follow_back,
        "whether things are followed back in time too, for the labels in the end");
  visit("recent", o.recent, "past scans, which show what moved");
  visit("segments", o.segments, "how a scan is cut");
  visit("tracker", o.tracker, "how what moves is followed");
}

// Whatever moves, a car or a chair as well as a person: beams on segments that are followed are
// left out of the alignment once it is known that they move, and of the map from first to last.
class SegmentFilter : public BeamFilter {
 public:
  using Options = SegmentFilterOptions;

  explicit SegmentFilter(const SegmentFilterOptions& options)
      : options_(options), tracker_(options.tracker) {}

  void add(const Odometry& reading) override { frame_.add(reading); }
  std::vector<float> add(const LaserScan& scan, std::span<const float> beam_weights) override;
  FilterResult result(const Trajectory& map_from_robot) const override;

 private:
  // Beams of a scan on something that is followed.
  using MetInScan = std::vector<SegmentTracker::Met>;

  std::vector<float> expected_weights(const LaserScan& scan) const;
  void label_back(BeamLabels& labels) const;

  SegmentFilterOptions options_;
  LocalFrame frame_;
  RecentScans recent_{options_.recent};
  SegmentTracker tracker_;
  TrackHistory history_;
  std::vector<KeptScan> scans_;
  std::vector<MetInScan> met_;  // in each of them
};

}  // namespace mapbed
