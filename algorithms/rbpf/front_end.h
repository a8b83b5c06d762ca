#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "algorithms/motion/odometry_track.h"
#include "algorithms/motion/track.h"
#include "algorithms/rbpf/proposal.h"
#include "algorithms/scan_matching/incremental_matcher.h"

namespace mapbed {

struct FrontEndOptions {
  Proposal proposal = Proposal::improved;
  double update_distance = 0.5;  // [m] of motion between updates
  double update_turn = 0.4;      // [rad] of turn between updates
  IncrementalMatcherOptions matcher;
};

// The robot's path by odometry and scan matching alone, and where on it the particles are updated:
// of the scans since the last update all but the newest are condensed into one corrected motion,
// Figure 5.4.
//
// No measurement is used twice: the matcher does not remember the scans that weight. Where scans
// are so far apart that each one weights, there is nothing to condense: then Proposal::improved
// lets the matcher see them, and the prior of the motion is that of odometry. From a match of the
// update's own scan it takes only where the search for each particle's optimum starts, and
// where the next motion begins.
class FrontEnd {
 public:
  explicit FrontEnd(const FrontEndOptions& options);

  struct Result {
    std::optional<Pose2> step;           // by odometry since the scan before, if there is any
    bool fits = true;                    // the scan, near where odometry has the robot
    std::optional<UpdateMotion> update;  // of the update that is due with this scan
  };
  void add(const Odometry& odometry);
  Result add(const LaserScan& scan, std::span<const float> beam_weights = {});

  bool newest_is_matched() const { return newest_.matched; }  // false: it fits nowhere near
  // Scans to come are matched with the newest one alone, not with what was seen before, so that at
  // least they lie right to each other.
  void forget_past();

  struct Update {
    double time = 0.0;
    Pose2 track_from_robot;
    Pose2 seen_from_robot;         // the same with the help of the update's scan
    Pose2 condensed;               // motion by scan matching, up to the last scan before
    double condensed_until = 0.0;  // [s] stamp of that
    bool is_condensed = false;     // there was one, and the matcher does not know the update's scan
  };
  // The anchors are the updates.
  const std::vector<Track::Scan>& scans() const { return scans_; }
  const std::vector<Update>& updates() const { return updates_; }
  // Scans that fitted nowhere or, where scans are not matched, had no odometry.
  std::vector<Remark> remarks_on_unknown_motion() const {
    return matcher_.remarks_on_unknown_motion();
  }
  int untrusted_scans() const { return matcher_.untrusted_scans() + unmoved_scans_; }

 private:
  // Where the robot is at a scan.
  struct Place {
    Pose2 track;            // without the scan, where that is held_out from the matcher
    Pose2 seen;             // with its help
    bool held_out = false;  // the matcher does not remember it: it weights
    // Found elsewhere than odometry's step from the last matched scan ends.
    bool contradicts_step = false;
    std::optional<Pose2> predicted = {};  // where odometry's last step was not believed
    bool matched = true;                  // false: it fits nowhere
  };
  Place place_of(const LaserScan& scan, std::span<const float> beam_weights,
                 const std::optional<Pose2>& step);
  bool is_due(const Pose2& track) const;
  // Where a scan since the update fitted nowhere, odometry knows better how the robot moved since.
  bool is_condensed() const { return condensed_scans_ > 0 && all_matched_; }
  UpdateMotion motion_to(const Place& place, const std::optional<Pose2>& step,
                         const std::optional<Pose2>& odometry, double time) const;

  FrontEndOptions options_;
  OdometryTrack odometry_;
  IncrementalMatcher matcher_;
  Place newest_;
  std::vector<Track::Scan> scans_;
  std::vector<Update> updates_;
  Pose2 track_from_robot_;   // at the last scan that was matched
  int condensed_scans_ = 0;  // since the last update
  bool all_matched_ = true;  // of these
  int unmoved_scans_ = 0;    // by Proposal::odometry, without any
  // odometry_from_robot at the last update, the last matched scan, the last scan.
  std::optional<Pose2> at_update_, at_matched_scan_, at_scan_;
};

}  // namespace mapbed
