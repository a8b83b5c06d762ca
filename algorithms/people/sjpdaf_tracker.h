#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "algorithms/people/front_end/scan_sightings.h"
#include "algorithms/people/joint_association.h"
#include "algorithms/people/learned_people.h"
#include "algorithms/people/people_number.h"
#include "algorithms/people/person_particles.h"
#include "algorithms/people/track_life.h"
#include "algorithms/remark.h"
#include "core/config/option.h"
#include "core/random.h"

namespace mapbed {

struct SjpdafOptions {
  int particles = 200;
  double detection = 0.9;
  double false_alarms = 0.02;        // [1/m^2]
  double place_false_alarms = 15.0;  // [1/m^2]
  double gate = 3.0;
  double discount = 0.2;
  double body_radius = 0.15;  // [m]
  double clutter = 0.05;
  int max_people = 40;
  int max_filters = 100;
  JointAssociationOptions association;
  PersonMotionOptions motion;
  PeopleNumberOptions number;
  TrackLifeOptions life;
};

template <class Visitor>
void visit_fields(SjpdafOptions& o, Visitor&& visit) {
  visit("particles", o.particles, between(10, 100'000), "samples of each person");
  visit("detection", o.detection, between(0.01, 0.999),
        "probability that somebody who is in view is detected");
  visit("false_alarms", o.false_alarms, between(1e-6, 100.0),
        "features in a square metre that are nobody's");
  visit("place_false_alarms", o.place_false_alarms, between(1e-6, 1000.0),
        "the same of features where something stood before");
  visit("gate", o.gate, between(0.5, 20.0),
        "sigmas from a person within which a feature may be his");
  visit("discount", o.discount, kFraction, "delta of (3.6)");
  visit("body_radius", o.body_radius, Unit::meter, between(0.01, 1.0),
        "of a person, of whom the scan may see a part");
  visit("clutter", o.clutter, between(0.0, 100.0), "false alarms of a scan, in P(m|N) of (3.5)");
  visit("max_people", o.max_people, between(1, 200), "in view, in P(m|N)");
  visit("max_filters", o.max_filters, between(1, 10'000),
        "of people and of what may turn out to be one");
  visit("association", o.association, "which feature is whose");
  visit("motion", o.motion, "how people walk");
  visit("number", o.number, "how the number of people changes");
  visit("life", o.life, "when somebody counts, and is given up");
}

// Section 3.2: sample-based joint probabilistic data association filters, one for each person, and
// as many of them as people seem to be in view. Who is hidden is kept, and his samples spread out.
// In the local frame; chance by person and scan.
class SjpdafTracker {
 public:
  using Options = SjpdafOptions;

  SjpdafTracker(const SjpdafOptions& options, std::shared_ptr<const LearnedPeople> learned,
                Rng rng);

  void predict(double time);               // to the stamp of the next scan
  void update(const ScanSightings& scan);  // of that scan

  std::vector<FollowedPerson> people() const;
  double mass_near(std::size_t person, const Eigen::Vector2d& point, double radius) const {
    return filters_[person].samples.mass_near(point, radius);
  }
  std::vector<Remark> remarks() const;

  // What the newest scan said of those who are followed, also of whom it ended; to learn from.
  struct Said {
    int id = 0;
    Eigen::Vector2d position = Eigen::Vector2d::Zero();  // [m]
    Evidence evidence;
  };
  const std::vector<Said>& said() const { return said_; }
  int features() const { return features_; }  // that counted in (3.5)
  // Of whom people() tells at that place; for pictures.
  const PersonParticles& samples(std::size_t person) const { return filters_[person].samples; }

 private:
  struct Filter {
    PersonParticles samples;
    TrackLife life;
    double mean_weight = 0.0;  // (3.6), discounted average of the weights' sum
    double hidden = 0.0;       // in the newest scan
  };
  struct Likelihoods {
    std::vector<std::vector<std::vector<double>>> of_samples;  // by person, sighting, sample
    Eigen::MatrixXd mean;                                      // (3.3)
  };

  void find_hidden(const ScanSightings& scan);
  Likelihoods likelihoods(const ScanSightings& scan) const;
  JointAssociation associated(const ScanSightings& scan, const Likelihoods& likelihoods) const;
  std::vector<double> weights_of_missed(const ScanSightings& scan,
                                        const PersonParticles& samples) const;
  void correct(const ScanSightings& scan, const Likelihoods& likelihoods,
               const JointAssociation& association);
  void adapt_number(const ScanSightings& scan, const JointAssociation& association);
  void remove_most_doubtful();
  void begin_at(const ScanSightings& scan, std::vector<const Sighting*> sightings);

  SjpdafOptions options_;
  std::shared_ptr<const LearnedPeople> learned_;
  Rng rng_;
  PeopleNumber number_;
  std::vector<Filter> filters_;
  std::vector<Said> said_;
  int features_ = 0;
  double time_ = 0.0;     // [s]
  double seconds_ = 0.0;  // [s] since the scan before
  bool has_begun_ = false;
  std::uint64_t scans_ = 0;
  int next_id_ = 0;
  long cut_clusters_ = 0;
};

}  // namespace mapbed
