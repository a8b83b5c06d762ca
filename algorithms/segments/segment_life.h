#pragma once

#include <Eigen/Core>

#include "algorithms/people/absence.h"
#include "algorithms/people/front_end/moved_features.h"
#include "core/config/option.h"

namespace mapbed {

// When what is followed counts as something that moves, and when it is given up.
struct SegmentLifeOptions {
  double confirm_time = 0.8;  // [s]
  double confirm_scans = 4.0;
  double confirm_travel = 0.5;  // [m]
  double confirm_robot = 0.2;   // [m]
  double straightness = 0.6;
  double steadiness = 0.75;
  double confirm_within = 4.0;  // [s]
  double forget_new = 0.25;     // [s]
  AbsenceOptions absence;
};

template <class Visitor>
void visit_fields(SegmentLifeOptions& o, Visitor&& visit) {
  visit("confirm_time", o.confirm_time, Unit::second, between(0.0, 60.0),
        "from the first scan that saw something to the last, before it counts");
  visit("confirm_scans", o.confirm_scans, between(0.0, 1000.0),
        "that saw it where earlier ones saw through, before it counts; where nobody looked before, "
        "a scan is half of one");
  visit("confirm_travel", o.confirm_travel, Unit::meter, between(0.0, 10.0),
        "from where it was first seen, before it counts");
  visit("confirm_robot", o.confirm_robot, Unit::meter, between(0.0, 10.0),
        "the same in the robot's frame");
  visit("straightness", o.straightness, kFraction,
        "distance from the start over the length of the way, before it counts");
  visit("steadiness", o.steadiness, kFraction, "of the time in which it is seen, before it counts");
  visit("confirm_within", o.confirm_within, Unit::second, between(0.0, 600.0),
        "by then what does not count is given up");
  visit("forget_new", o.forget_new, Unit::second, between(0.0, 60.0),
        "without being seen, after which what does not count yet is given up");
  visit_fields(o.absence, visit);
}

// What a scan says of something.
struct SeenSegment {
  bool is_seen = false;
  SeenBefore before = SeenBefore::nothing;               // at the place where it is seen
  double hidden = 0.0;                                   // how likely it could not be seen
  SeenBefore at_start = SeenBefore::nothing;             // now, where it was first seen
  Eigen::Vector2d position = Eigen::Vector2d::Zero();    // [m] where it is, in the local frame
  Eigen::Vector2d from_robot = Eigen::Vector2d::Zero();  // [m] and in the robot's
};

// From when something is first seen to when it is given up. It counts once it went some
// way, rather straight and not just along with the robot, of which it would be a part; was seen
// often enough where nothing stood before; and left the place where it began: what belongs to the
// place is still there when a track jumps on to the next such thing.
class SegmentLife {
 public:
  SegmentLife(int id, double time, const SeenSegment& first);

  void update(double time, const SeenSegment& sighted, const SegmentLifeOptions& options);

  int id() const { return id_; }
  bool is_seen() const { return is_seen_; }
  bool is_confirmed() const { return is_confirmed_; }
  const Eigen::Vector2d& start() const { return first_.position; }
  bool is_over(double time, double spread, const SegmentLifeOptions& options) const;

 private:
  void add_evidence(SeenBefore before);
  bool has_moved(const SegmentLifeOptions& options) const;

  int id_;
  double first_seen_;  // [s]
  Absence absence_;
  double seen_time_ = 0.0;  // [s] in which it was seen
  SeenSegment first_;
  Eigen::Vector2d position_;  // [m] the newest one
  double path_ = 0.0;         // [m] length of the way
  double free_ = 0.0;         // scans that saw it where earlier ones saw through
  double not_same_ = 0.0;     // the same, and by half those where nobody looked before
  bool is_seen_ = true;
  bool is_confirmed_ = false;
};

}  // namespace mapbed
