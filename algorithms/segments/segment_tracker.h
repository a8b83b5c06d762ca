#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "algorithms/motion/constant_velocity.h"
#include "algorithms/people/track_life.h"
#include "algorithms/segments/scan_segments.h"
#include "algorithms/segments/segment_life.h"
#include "core/config/option.h"

namespace mapbed {

struct SegmentTrackerOptions {
  double acceleration = 1.0;  // [m/s] after 1 s
  double speed_sigma = 1.0;   // [m/s]
  double gate = 0.4;          // [m]
  double join = 0.4;          // [m]
  double largest = 6.0;       // [m]
  int least_beams = 2;
  SegmentLifeOptions life;
};

template <class Visitor>
void visit_fields(SegmentTrackerOptions& o, Visitor&& visit) {
  visit("acceleration", o.acceleration, Unit::meter_per_second, between(0.01, 50.0),
        "sigma of the change of velocity after 1 s; it grows with the root");
  visit("speed_sigma", o.speed_sigma, Unit::meter_per_second, between(0.01, 50.0),
        "of the velocity along each axis, of something new");
  visit("gate", o.gate, Unit::meter, between(0.01, 10.0),
        "from something that is followed within which a segment may be a part of it");
  visit("join", o.join, Unit::meter, between(0.0, 10.0),
        "between segments that are one new thing: two legs, four of a chair");
  visit("largest", o.largest, Unit::meter, between(0.1, 100.0), "side of something that moves");
  visit("least_beams", o.least_beams, between(1, 1000), "on something new");
  visit("life", o.life, "when something counts, and is given up");
}

// What a tracker is given of one scan.
struct SegmentedScan {
  const ScanView& view;
  Pose2 local_from_robot;
  std::vector<ScanSegment> segments;
};

// Things of any kind that move, in the tradition of Wang, Thorpe and Thrun ("Online simultaneous
// localization and mapping with detection and tracking of moving objects", 2003): segments of a
// scan where earlier ones saw through are something new, of constant velocity; of what follows each
// segment belongs to what it is nearest to. It counts once it has moved (SegmentLife). Of what it
// is only its box is known, in the local frame. A thing of which now this side is seen and now that
// seems to move a little; two that walk together are one.
class SegmentTracker {
 public:
  explicit SegmentTracker(const SegmentTrackerOptions& options) : options_(options) {}

  void predict(double time);               // to the stamp of the next scan
  void update(const SegmentedScan& scan);  // of that scan

  std::vector<FollowedPerson> followed() const;
  // Where those that count are held to be, for beams of the scan that comes next.
  std::vector<Eigen::AlignedBox2d> boxes() const;
  // Of the newest scan: which of those that are followed (by id) a beam met.
  struct Met {
    int id = 0;
    std::size_t beam = 0;
    bool is_confirmed = false;
  };
  std::vector<Met> met() const;

 private:
  struct Track {
    ConstantVelocity state;
    SegmentLife life;
    Eigen::Vector2d half;             // [m] of its box
    double side;                      // [m] the longest, when it began to count or until now
    std::vector<std::size_t> beams;   // of the newest scan
    Eigen::AlignedBox2d box() const;  // where it is held to be
  };
  double besides() const;
  double may_grow_to(const Track& track) const;
  bool may_be_of(const Track& track, const ScanSegment& segment,
                 const Eigen::AlignedBox2d& found) const;
  std::vector<std::vector<std::size_t>> assigned(const SegmentedScan& scan) const;
  void add_rest(const Track& track, const SegmentedScan& scan,
                std::vector<std::size_t>& segments) const;
  void see(Track& track, const SegmentedScan& scan, const std::vector<std::size_t>& segments);
  void begin_tracks(const SegmentedScan& scan, const std::vector<bool>& is_taken);

  SegmentTrackerOptions options_;
  std::vector<Track> tracks_;
  double time_ = 0.0;  // [s]
  bool has_begun_ = false;
  int next_id_ = 0;
};

}  // namespace mapbed
