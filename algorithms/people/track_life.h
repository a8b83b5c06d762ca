#pragma once

#include <deque>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "algorithms/people/absence.h"
#include "algorithms/people/front_end/scan_sightings.h"
#include "algorithms/people/learned_people.h"
#include "core/config/option.h"

namespace mapbed {

// When what is followed is somebody, and when he is given up: the same for every tracker.
struct TrackLifeOptions {
  double prior = 0.06;
  double memory = 1.2;  // [s]
  double confirm = 0.99;
  double confirm_travel = 0.4;  // [m]
  double give_up = 0.005;
  double forget_new = 0.5;  // [s]
  AbsenceOptions absence;
};

template <class Visitor>
void visit_fields(TrackLifeOptions& o, Visitor&& visit) {
  visit("prior", o.prior, between(1e-6, 0.999),
        "probability that what is seen for the first time is a person who walks");
  visit("memory", o.memory, Unit::second, between(0.001, 60.0),
        "in which scans say the same again of who does not come to a new place, or is not seen");
  visit("confirm", o.confirm, between(0.5, 1.0 - 1e-9),
        "probability of being a person, from which on what is followed counts as one");
  visit("confirm_travel", o.confirm_travel, Unit::meter, between(0.0, 10.0),
        "from where he was first seen, before he counts");
  visit("give_up", o.give_up, between(1e-9, 0.5),
        "probability of being a person, below which it is given up");
  visit(
      "forget_new", o.forget_new, Unit::second, between(0.0, 60.0),
      "without being seen although nothing hides it, after which what does not count yet is given "
      "up");
  visit_fields(o.absence, visit);
}

// One of the people a tracker follows, in the local frame.
struct FollowedPerson {
  int id = 0;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();    // [m]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();    // [m/s]
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  // [m^2] of the position
  bool is_seen = false;                                  // in the newest scan
  bool is_confirmed = false;                             // counts as a person
};

// From when something is first seen to when it is given up. The probability that it is a person who
// walks is that of Bayes' rule over all scans, as track-oriented trackers score their hypotheses
// (Blackman and Popoli, 1999, ch. 6).
class TrackLife {
 public:
  TrackLife(int id, double time, const Eigen::Vector2d& position, const TrackLifeOptions& options);

  // The past scans of a new one, before anything is asked about its sightings.
  void recall(const PastScans& past);
  // What stood before where he may be seen now, he himself apart.
  SeenBefore before(const PastScans& past, const Sighting& sighting) const;
  // `sighting` null: he is not seen, and was hidden with a probability. Gives what the scan said of
  // him that was not said before.
  std::optional<Evidence> update(const ScanSightings& scan, const Sighting* sighting, double hidden,
                                 const Eigen::Vector2d& position, const TrackLifeOptions& options,
                                 const LearnedPeople& learned);

  int id() const { return id_; }
  bool is_seen() const { return is_seen_; }
  bool is_confirmed() const { return is_confirmed_; }
  double probability() const;
  // Not seen for a while although nothing hides him.
  bool is_missed(const TrackLifeOptions& options) const {
    return absence_.in_view() > options.forget_new;
  }
  bool is_over(double time, double spread, const TrackLifeOptions& options) const;

 private:
  struct Place {
    double time;               // [s]
    Eigen::Vector2d position;  // [m]
  };
  std::optional<Evidence> evidence(const ScanSightings& scan, const Sighting* sighting,
                                   const TrackLifeOptions& options);
  Evidence::Left left(const ScanSightings& scan) const;

  int id_;
  Absence absence_;
  double log_odds_;                    // of being a person who walks
  Eigen::Vector2d start_;              // [m]
  std::deque<Place> way_;              // of the last seconds, the newest at the end
  std::vector<Eigen::Vector2d> then_;  // [m] where he was at each past scan; NaN: not there yet
  Eigen::Vector2d place_;              // [m] of the last step
  double since_evidence_ = 0.0;        // [s]
  bool is_steady_ = true;              // since then
  bool is_seen_ = true;
  bool is_confirmed_ = false;
};

}  // namespace mapbed
