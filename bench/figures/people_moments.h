#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "algorithms/people/tracking_filter.h"
#include "bench/figures/figure_log.h"

namespace mapbed {

// Somebody who counts as a person, in the local frame of chapter 3's filter.
struct PersonThen {
  FollowedPerson person;
  std::vector<Eigen::Vector2d> samples;  // [m] p(h^i) of section 3.2.1
  std::vector<Eigen::Vector2d> way;      // [m] where he was held to be before, the newest last
};

// What the filter held at one scan.
struct PeopleMoment {
  double seconds = 0.0;            // since the log's start
  ScanSightings found;             // of that scan
  std::optional<KeptScan> before;  // the scan that it is compared with, Figure 3.2
  std::vector<PersonThen> people;
  std::vector<Eigen::Vector2d> truth;  // [m] people in truth, in the local frame
  double footprint = 0.0;              // [m] TrackingFilterOptions::footprint
};

// A drive as chapter 3's filter follows the people in it, scan by scan.
class PeopleDrive {
 public:
  // Throws InputError for a log without scans. The log must outlive this.
  PeopleDrive(const FigureLog& log, const PeopleFilter::Options& options);

  std::size_t scans() const { return people_.size(); }
  double seconds_at(std::size_t scan) const;  // since the log's start
  std::size_t scan_at(double seconds) const;  // the newest one by then, or the first
  const std::vector<FollowedPerson>& people_at(std::size_t scan) const { return people_[scan]; }

  // The scan in which the most people are seen near the robot; the first of several.
  std::size_t busiest_scan() const;

  // Somebody whom something hid for a while and who is still followed after that.
  struct Occlusion {
    int id = 0;
    std::size_t first = 0, last = 0;  // scans in which he was hidden
  };
  std::optional<Occlusion> longest_occlusion() const;

  // What was held at these scans, in rising order.
  std::vector<PeopleMoment> moments(const std::vector<std::size_t>& scans) const;

 private:
  bool is_seen_at(int id, std::size_t scan) const;
  PeopleMoment moment(const PeopleFilter& filter) const;
  std::vector<Eigen::Vector2d> way_of(int id, std::size_t scan) const;

  const FigureLog& log_;
  PeopleFilter::Options options_;
  std::shared_ptr<const LearnedPeople> learned_;
  PeopleFilter filter_;                              // at the end of the drive
  std::vector<std::vector<FollowedPerson>> people_;  // at each scan
};

}  // namespace mapbed
