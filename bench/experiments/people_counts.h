#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "algorithms/people/learned_people.h"
#include "bench/metrics/tracking_frame.h"
#include "core/config/option.h"

namespace mapbed {

// Every evidence that there is, by number: steps of whom is seen steadily, the other ones, no step,
// not seen.
inline constexpr std::size_t kEvidences = 37;
std::size_t number_of(const Evidence& evidence);
// The value of a parameter file that says it: "steady_step.free", the third of them.
std::pair<std::string, std::size_t> place_of_evidence(std::size_t number);

// How often what was seen of people who walk, and of anything else, and in how many scans so many
// people who had walked were in view (row) and so many features counted (column).
struct PeopleCounts {
  std::array<double, kEvidences> people{};
  std::array<double, kEvidences> others{};
  std::vector<std::vector<double>> scans;

  void add(const PeopleCounts& more);
  void add_scan(std::size_t people_in_view, std::size_t features);
  double of_people() const;
  double of_others() const;
  double of_scans() const;
};

// What a tracker made of one scan, in the frame of the truth.
struct FollowedScan {
  struct Said {
    int id = 0;
    Eigen::Vector2d position = Eigen::Vector2d::Zero();  // [m]
    Evidence evidence;
  };
  std::vector<int> followed;  // ids, after it
  std::vector<Said> said;
  int features = 0;  // that counted in (3.5)
};

struct CountingOptions {
  double first = 4.0;  // [s]
  double near = 0.4;   // [m]
  double far = 0.9;    // [m]
  double least_seen = 2.0;
};

template <class Visitor>
void visit_fields(CountingOptions& o, Visitor&& visit) {
  visit("first", o.first, Unit::second, kPositive,
        "since the tracker took something up, in which is counted what is said of it");
  visit("near", o.near, Unit::meter, kPositive,
        "of somebody who has walked since he came into view: it is he");
  visit("far", o.far, Unit::meter, kPositive, "from everybody: it is anything else");
  visit("least_seen", o.least_seen, between(1e-6, 1e6),
        "times that an evidence is counted besides as often of people as of anything else, so that "
        "one which was seldom seen says little");
}

// `truth` has a frame for each scan, numbered by appearance (who_counts.h).
PeopleCounts counted(const std::vector<FollowedScan>& scans, const TrackingFrames& truth,
                     const CountingOptions& options);

// Rounded to hundredths.
LearnedPeople learned_from(const PeopleCounts& counts, const CountingOptions& options);

// The parameter file, with the counts that each value rests on.
std::string learned_yaml(const LearnedPeople& learned, const PeopleCounts& counts);

// Mean -ln of the probability that the right one has, people or else, of an evidence that is drawn
// as often of the ones as of the others. ln 2: the evidence says nothing.
double evidence_loss(const PeopleCounts& counts, const LearnedPeople& learned);

// Mean -ln P(m | N) of a scan.
double number_loss(const PeopleCounts& counts, const FeatureNumbers& numbers);

// Of the values of both that were counted often enough, the root mean square of their difference,
// over the error of counting and of rounding the file to tenths. 1: both say the same.
double difference_by_error(const LearnedPeople& file, const LearnedPeople& learned,
                           const PeopleCounts& counts);

}  // namespace mapbed
