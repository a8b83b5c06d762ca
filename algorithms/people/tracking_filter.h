#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/beam_filter.h"
#include "algorithms/people/front_end/people_front_end.h"
#include "algorithms/people/kalman_tracker.h"
#include "algorithms/people/learned_people.h"
#include "algorithms/people/sjpdaf_tracker.h"
#include "algorithms/people/track_history.h"
#include "core/config/option.h"
#include "core/random.h"

namespace mapbed {

// How people are kept out of the alignment of scans.
enum class PeopleInAlignment : int {
  weights,  // each beam counts by how likely it met nobody, (3.11)
  boxes,    // what ends in somebody's bounding box is left out, all else counts fully
  none,     // all beams count fully
};

template <class TrackerOptions>
struct TrackingFilterOptions {
  std::string learned = "corridor_and_museum";
  PeopleInAlignment alignment = PeopleInAlignment::weights;
  double alignment_box = 0.4;  // [m]
  double footprint = 0.35;     // [m]
  double sure = 0.5;
  LabelOptions labels;
  bool follow_back = true;
  PeopleFrontEndOptions front_end;
  TrackerOptions tracker;
};

template <class TrackerOptions, class Visitor>
void visit_fields(TrackingFilterOptions<TrackerOptions>& o, Visitor&& visit) {
  visit("learned", o.learned,
        "what was learned of people and of all else: a file in algorithms/people/people_models");
  visit("alignment", o.alignment, {"weights", "boxes", "none"},
        "how people are kept out of the alignment of scans");
  visit("alignment_box", o.alignment_box, Unit::meter, between(0.0, 10.0),
        "from somebody to each side of the box that is left out, with boxes");
  visit("footprint", o.footprint, Unit::meter, between(0.01, 5.0),
        "radius of what somebody covers: he reflected a beam that ends so near");
  visit("sure", o.sure, kFraction,
        "probability that a beam met somebody, above which it is left out");
  visit("box", o.labels.box, Unit::meter, between(0.0, 10.0),
        "from somebody to each side of the box whose beams the map leaves out");
  visit("margin", o.labels.margin, Unit::second, between(0.0, 60.0),
        "before somebody was first seen and after he was last, in which beams are left out too");
  visit("keep_place", o.labels.keep_place,
        "whether the map keeps beams in a box that end where something stands without him, too");
  visit("follow_back", o.follow_back,
        "whether people are followed back in time too, for the labels in the end");
  visit("front_end", o.front_end, "from scans to features");
  visit("tracker", o.tracker, "from features to people");
}

// Chapter 3: people are followed, and beams that they reflect kept out of the alignment of scans,
// (3.9)-(3.11), and of the map. Online; labels are told in the end, with people followed back in
// time as well: who stood there before he went, and who was somebody before a tracker could know
// it.
template <class Tracker>
class TrackingFilter : public BeamFilter {
 public:
  using Options = TrackingFilterOptions<typename Tracker::Options>;

  // `learned` as options.learned names it; without it, it is read here.
  TrackingFilter(const Options& options, std::shared_ptr<const LearnedPeople> learned, Rng rng);
  TrackingFilter(const Options& options, Rng rng);

  void add(const Odometry& reading) override { front_end_.add(reading); }
  std::vector<float> add(const LaserScan& scan, std::span<const float> beam_weights) override;
  FilterResult result(const Trajectory& map_from_robot) const override;

  // For pictures: the scans so far, what the newest one gave, and who is followed there.
  const std::vector<KeptScan>& scans() const { return scans_; }
  const ScanSightings& newest() const { return *newest_; }  // not before the first scan
  const Tracker& tracker() const { return tracker_; }

 private:
  std::vector<float> probabilities_of_people(const Tracker& tracker, const LaserScan& scan,
                                             const Pose2& local_from_robot) const;
  std::vector<bool> surely_on_people(const std::vector<float>& on_people) const;
  std::vector<float> weights(const std::vector<float>& on_people) const;
  std::vector<TrackHistory::States> followed_back() const;

  Options options_;
  std::shared_ptr<const LearnedPeople> learned_;
  Rng rng_;
  PeopleFrontEnd front_end_;
  Tracker tracker_;
  TrackHistory history_;
  std::vector<KeptScan> scans_;
  std::optional<ScanSightings> newest_;
};

extern template class TrackingFilter<SjpdafTracker>;
extern template class TrackingFilter<KalmanTracker>;

using PeopleFilter = TrackingFilter<SjpdafTracker>;
using KalmanPeopleFilter = TrackingFilter<KalmanTracker>;

}  // namespace mapbed
