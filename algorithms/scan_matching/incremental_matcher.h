#pragma once

#include <optional>
#include <vector>

#include "algorithms/estimator.h"
#include "algorithms/motion/learned_spread.h"
#include "algorithms/motion/odometry_track.h"
#include "algorithms/motion/recent_motion.h"
#include "algorithms/scan/level_lasers.h"
#include "algorithms/scan_matching/incremental_matcher_options.h"
#include "algorithms/scan_matching/local_scans.h"
#include "algorithms/scan_matching/match_covariance.h"
#include "algorithms/scan_matching/matching_diagnostics.h"
#include "algorithms/scan_matching/scan_matcher.h"

namespace mapbed {

// Incremental scan matching, section 2.3: each scan is aligned with a local map of a bounded number
// of past scans (Algorithm 1), starting where odometry or the last motion predicts. Where hill
// climbing starts without odometry, or ends with a match that explains little (a side optimum, if
// not a changed world), a correlative search over a window looks for a better start; where that
// match is not to be trusted either, a wider one takes the prediction for wrong (wheels that spun,
// a robot that was turned by hand). Hits on ground that the local map does not know say nothing.
// Where odometry's last step contradicts what odometry and scans say of the last seconds together,
// the robot is also looked for where that and its speed would have it. Errors add up over time:
// loops stay open. Memory is bounded by the local map, the trajectory apart.
class IncrementalMatcher : public Estimator {
 public:
  // `start` is map_from_robot at the first scan.
  explicit IncrementalMatcher(const IncrementalMatcherOptions& options = {},
                              const Pose2& start = {});

  void add(const Measurement& measurement, std::span<const float> beam_weights = {}) override;
  Pose2 pose() const override { return map_from_robot_; }
  Estimate estimate() const override;

  int untrusted_scans() const { return untrusted_scans_; }
  std::vector<Remark> remarks_on_unknown_motion() const;

  // Where a scan would be put; it is not remembered.
  ScanMatch match(const LaserScan& scan, std::span<const float> beam_weights = {});

  // Goes on without the local map, but for its newest scan where that is kept: as after scans that
  // do not fit what was seen before.
  void forget_past(bool keep_newest);

  // Of the newest scan; its pose is pose().
  const ScanMatch& last_match() const { return last_match_; }
  // What is not known of a motion to the newest scan, over so many scans and seconds, where
  // odometry does not help: where that scan says nothing, as along a bare corridor, the robot went
  // on much as before. Of (x, y, theta) in the robot frame; none with odometry, or where nothing
  // fits.
  std::optional<Eigen::Matrix3d> blind_spread(int scans, double seconds) const;

 private:
  struct Prediction {
    PosePrior prior;
    bool blind = false;  // without odometry
  };
  struct OtherPrediction {
    PosePrior prior;
    bool is_likelier =
        false;  // nearer to where the robot is at its speed than odometry's last step
  };
  // A scan as it is matched.
  struct Hits {
    std::vector<Eigen::Vector2d> points;  // [m] in the robot frame
    std::vector<float> weights;           // of beams, as told; empty: all count fully
    std::vector<float> footprints;        // as they count by these; empty: fully
    Pose2 robot_from_laser;
  };
  // Those of its points that are matched. A search for where most of them fit takes them alike: how
  // well each of them is known counts for where just.
  struct KnownPoints {
    FieldPoints climbed;
    std::vector<float> weights;  // in a search
    FieldPoints searched() const;
  };
  Hits hits_of(const LaserScan& scan, std::span<const float> beam_weights) const;
  std::optional<MatchInformation> information_by(const LaserScan& scan) const;
  void add_scan(const LaserScan& scan, std::span<const float> beam_weights);
  std::optional<Pose2> odometry_at(double time) const;
  Prediction predicted(double time) const;
  std::vector<OtherPrediction> other_predictions(double time, bool by_step_is_doubtful) const;
  void learn_spread(double time);
  PosePrior going_on(double time) const;
  ScanMatch matched(const Hits& hits, const Prediction& prediction);
  ScanMatch matched_near(const Hits& hits, const Prediction& prediction);
  KnownPoints known_points(const Hits& hits, const Pose2& predicted) const;
  KnownPoints kept(const Hits& hits, const std::vector<bool>& keeps) const;
  KnownPoints points_on_lines(const Hits& hits, const Pose2& pose) const;
  ScanMatch climbed(const KnownPoints& points, const Prediction& prediction);
  ScanMatch best_of(const Hits& hits, const ScanMatch& by_step,
                    const std::vector<OtherPrediction>& others);
  ScanMatch searched_widely(const Hits& hits, const Prediction& prediction,
                            const ScanMatch& match) const;

  IncrementalMatcherOptions options_;
  LevelLasers lasers_;
  OdometryTrack odometry_;
  Pose2 map_from_robot_;
  ScanMatch last_match_;
  std::optional<MatchInformation> blind_information_;
  Trajectory trajectory_;
  int untrusted_scans_ = 0;
  MatchingDiagnostics diagnostics_;
  std::optional<Pose2> odometry_at_last_scan_;
  RecentMotion recent_;
  LearnedSpread learned_spread_;
  LocalScans local_scans_;
};

}  // namespace mapbed
