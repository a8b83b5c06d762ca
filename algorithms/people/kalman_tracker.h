#pragma once

#include <memory>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "algorithms/motion/constant_velocity.h"
#include "algorithms/people/front_end/scan_sightings.h"
#include "algorithms/people/learned_people.h"
#include "algorithms/people/track_life.h"
#include "algorithms/remark.h"
#include "core/config/option.h"
#include "core/random.h"

namespace mapbed {

struct KalmanTrackerOptions {
  double acceleration = 0.7;  // [m/s] after 1 s
  double speed_sigma = 0.8;   // [m/s]
  double gate = 3.0;
  double place_penalty = 16.0;
  double body_radius = 0.15;  // [m]
  TrackLifeOptions life;
};

template <class Visitor>
void visit_fields(KalmanTrackerOptions& o, Visitor&& visit) {
  visit("acceleration", o.acceleration, Unit::meter_per_second, between(0.01, 50.0),
        "sigma of the change of velocity after 1 s; it grows with the root");
  visit("speed_sigma", o.speed_sigma, Unit::meter_per_second, between(0.01, 20.0),
        "of the velocity along each axis, of somebody new");
  visit("gate", o.gate, between(0.5, 20.0),
        "sigmas from a person within which a feature may be his");
  visit("place_penalty", o.place_penalty, between(0.0, 1000.0),
        "on the squared distance in sigmas, of features where something stood before");
  visit("body_radius", o.body_radius, Unit::meter, between(0.01, 1.0),
        "of a person, of whom the scan may see a part");
  visit("life", o.life, "when somebody counts, and is given up");
}

// The plain tracker that others are compared with: a Kalman filter of constant velocity for each
// person, each feature given to the one it is nearest to (the assignment of least total cost), a
// new person for each feature that moved and is nobody's. In the local frame.
class KalmanTracker {
 public:
  using Options = KalmanTrackerOptions;

  KalmanTracker(const KalmanTrackerOptions& options, std::shared_ptr<const LearnedPeople> learned,
                const Rng&)
      : options_(options), learned_(std::move(learned)) {}

  void predict(double time);               // to the stamp of the next scan
  void update(const ScanSightings& scan);  // of that scan

  std::vector<FollowedPerson> people() const;
  // Of the normal distribution within a circle, by its density there.
  double mass_near(std::size_t person, const Eigen::Vector2d& point, double radius) const;
  std::vector<Remark> remarks() const { return {}; }

 private:
  struct Filter {
    ConstantVelocity state;
    TrackLife life;
  };
  std::vector<int> assigned(const ScanSightings& scan) const;

  KalmanTrackerOptions options_;
  std::shared_ptr<const LearnedPeople> learned_;
  std::vector<Filter> filters_;
  double time_ = 0.0;  // [s]
  bool has_begun_ = false;
  int next_id_ = 0;
};

}  // namespace mapbed
