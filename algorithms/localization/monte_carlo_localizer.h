#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "algorithms/estimator.h"
#include "algorithms/localization/free_space.h"
#include "algorithms/localization/known_times.h"
#include "algorithms/localization/monte_carlo_options.h"
#include "algorithms/localization/particle_weights.h"
#include "algorithms/localization/pose_answer.h"
#include "algorithms/motion/odometry_track.h"
#include "algorithms/scan/level_lasers.h"
#include "core/random.h"

namespace mapbed {

// Monte Carlo localisation in a map that is given, section 7.4, (7.3): particles move by odometry,
// are weighted by what sensors say, and are drawn anew where few of them count, as many as the
// belief needs. Where measurements get unlikely some are drawn from what these say by themselves,
// so that a robot that was carried away, or begins anywhere, is found.
//
// The answer is the mean of the particles about the place that most of the belief is about. It
// counts as known where nearly all of the belief is there, narrow enough, and the measurements fit
// the map there; elsewhere the estimate is lost, and says so. Poses are those of the time: later
// measurements do not correct them.
class MonteCarloLocalizer : public Estimator {
 public:
  using AllWeights = std::vector<std::unique_ptr<ParticleWeights>>;

  // Begins about `start`, map_from_robot, or else anywhere in the space.
  MonteCarloLocalizer(const MonteCarloOptions& options, const FreeSpace& space, AllWeights weights,
                      std::optional<Pose2> start, const Rng& rng);

  void add(const Measurement& measurement, std::span<const float> beam_weights = {}) override;
  Pose2 pose() const override;
  Estimate estimate() const override;

  const std::vector<Pose2>& particles() const { return poses_; }  // map_from_robot
  bool is_known() const { return state() == Unknown::none; }

 private:
  // When a sensor weighted the particles the last time.
  struct Taken {
    double time = 0.0;              // [s]
    std::optional<Pose2> odometry;  // odometry_from_robot then
  };

  // Poses at the stamps of one kind of measurement.
  struct Told {
    Trajectory trajectory;
    std::vector<Eigen::Matrix3d> covariances;
    KnownTimes known;
  };

  void tell_pose(double time, Told& told) const;
  const Told& told() const;
  bool is_due(std::size_t sensor, double time) const;
  std::optional<Pose2> motion_between_times(const std::optional<Pose2>& odometry,
                                            double time) const;
  std::optional<Pose2> motion_until(double time) const;  // since the last update
  Pose2 pose_at(double time) const;
  Unknown state() const;
  bool is_narrow() const { return answer_.largest_sigma() <= options_.known_sigma; }
  bool begin(const ParticleWeights& weights);
  void move_until(double time);
  void weigh(std::size_t sensor, bool is_drawn_by_it);
  void judge(const ParticleWeights& weights, const Pose2& predicted);
  double doubt() const;
  double poverty(const ParticleWeights& weights, Rng& rng) const;
  void draw_anew(std::size_t sensor);
  Pose2 drawn_anywhere(const ParticleWeights& weights, Rng& rng) const;
  Pose2 drawn_near(const Pose2& pose, const ParticleWeights& weights, Rng& rng) const;

  MonteCarloOptions options_;
  FreeSpace space_;
  AllWeights weights_;
  std::vector<LikelihoodMeans> likelihoods_;  // by sensor
  std::vector<std::optional<Taken>> taken_;   // by sensor
  std::optional<Pose2> start_;
  Rng rng_;
  LevelLasers lasers_;
  OdometryTrack odometry_;

  std::vector<Pose2> poses_;  // map_from_robot at the last update; empty: nothing was seen yet
  std::vector<double> log_weights_;
  int updates_ = 0;
  double updated_ = 0.0;                     // [s]
  std::optional<Pose2> odometry_at_update_;  // odometry_from_robot
  double likelihood_ = HUGE_VAL;             // of the newest measurement, by all particles
  PoseAnswer answer_;
  PlaceBelief place_;  // a start that is told counts as known until scans contradict

  Told of_scans_, of_rounds_;
  int without_odometry_ = 0;  // updates
};

}  // namespace mapbed
