#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "bench/results/replay.h"
#include "bench/sources/run_viewer.h"
#include "core/interrupted.h"
#include "core/sensor/laser_scan.h"

namespace mapbed {

// What a method believed at a moment, in the frame of its own map.
struct CourseStep {
  double time = 0.0;              // [s] of the last scan of its path
  std::size_t kept = 0;           // poses of the path that are those of the step before
  std::vector<Pose2> later = {};  // those after them: map_from_robot, one a scan
  // Poses held possible now, and the newest parts of the paths that led to them; none of a method
  // that has one path only.
  std::vector<Pose2> particles = {};
  std::vector<std::vector<Eigen::Vector2f>> branches = {};
};

// A run as it went: what a film is made of.
struct Course {
  std::string method;
  Pose2 world_from_map;            // where the truth is known: by the first pose
  double start = 0.0, end = 0.0;   // [s] of the log, absolute
  std::vector<CourseStep> steps;   // by time
  std::optional<CourseStep> last;  // what came of it in the end, with all of the path
  // By their place in the path: those of the steps and those that the map is made of.
  std::map<std::size_t, LaserScan> scans;
  std::vector<std::size_t> of_map;

  std::vector<std::vector<Eigen::Vector2d>> outlines;  // [m] of what stands still, in the world
  // Of methods that tell what moves, as they hold it in the end: of the scans, by their place in
  // the path; and who is followed, in the world.
  std::map<std::size_t, ScanLabels> labels;
  Tracks tracks;

  Trajectory truth;                 // world_from_robot; empty: nobody knows
  std::vector<ReplayTrack> others;  // people, doors
};

// Which moments are looked at.
struct CourseMoments {
  double from = 0.0;                                    // [s] since the log's start
  double to = std::numeric_limits<double>::infinity();  // the run ends there
  double step = 0.0;                                    // [s] at most one in so many
};

// Keeps the course of the run that it views.
class CourseRecorder : public RunViewer {
 public:
  // The moments, once the length [s] of the log is known; how far it is, [s] of the log.
  using Choose = std::function<CourseMoments(double length)>;
  using Tell = std::function<void(double seconds)>;
  // Where `goes_on` says no, the run ends, and nothing is complete.
  CourseRecorder(Choose choose, Tell tell, GoesOn goes_on);

  void begins(const RunInput& prepared, const std::string& method) override;
  void after(const Measurement& measurement, const Estimator& estimator) override;
  void ends(const Estimate& estimate) override;

  bool is_complete() const override { return is_complete_; }  // all moments were looked at
  bool has_begun() const { return input_ != nullptr; }
  const Course& course() const { return course_; }

 private:
  void take_scan(const LaserScan& scan, const Pose2& map_from_robot);
  void look(const LaserScan& scan, const Estimator& estimator);
  void tell_path(const Trajectory& path, CourseStep& step);
  void align(const Stamped<Pose2>& first);
  void tell_what_moves(const Estimate& estimate);
  void replay(const Estimate& estimate);  // of a method that showed nothing on its way

  Choose choose_;
  Tell tell_;
  GoesOn goes_on_;
  const RunInput* input_ = nullptr;
  CourseMoments moments_;
  Course course_;
  bool is_complete_ = false;
  bool is_aligned_ = false;
  double next_ = 0.0;        // [s] of the next moment, absolute
  std::size_t taken_ = 0;    // scans so far
  std::vector<Pose2> path_;  // at the last step
  std::optional<Stamped<Pose2>> of_newest_map_scan_;
};

}  // namespace mapbed
