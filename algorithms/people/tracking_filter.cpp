#include "algorithms/people/tracking_filter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "algorithms/scan/beam_weights.h"

namespace mapbed {
namespace {

constexpr double kSpreads = 3.0;  // beyond so many sigmas nobody has any mass

Remark remark_on(const Tracks& tracks) {
  std::size_t states = 0;
  for (const ObjectTrack& track : tracks) states += track.states.size();
  if (tracks.empty()) return {RemarkKind::note, "people: nobody was seen to move"};
  return {RemarkKind::note,
          fmt::format(
              "people: {} {} of {:.1f} scans in the mean; who is lost and found again has several",
              tracks.size(), tracks.size() == 1 ? "track" : "tracks",
              static_cast<double>(states) / static_cast<double>(tracks.size()))};
}

std::vector<float> product(std::vector<float> weights, std::span<const float> others) {
  for (std::size_t b = 0; b < others.size(); ++b) weights[b] *= others[b];
  return weights;
}

}  // namespace

template <class Tracker>
TrackingFilter<Tracker>::TrackingFilter(const Options& options,
                                        std::shared_ptr<const LearnedPeople> learned, Rng rng)
    : options_(options),
      learned_(std::move(learned)),
      rng_(rng),
      front_end_(options.front_end),
      tracker_(options.tracker, learned_, rng_.stream("forward")) {}

template <class Tracker>
TrackingFilter<Tracker>::TrackingFilter(const Options& options, Rng rng)
    : TrackingFilter(options,
                     std::make_shared<const LearnedPeople>(load_learned_people(options.learned)),
                     rng) {}

template <class Tracker>
std::vector<float> TrackingFilter<Tracker>::add(const LaserScan& scan,
                                                std::span<const float> beam_weights) {
  const LaserScan believed = beam_weights.empty() ? scan : with_failed_beams(scan, beam_weights);
  tracker_.predict(scan.time);
  const std::vector<float> predicted =
      weights(probabilities_of_people(tracker_, believed, front_end_.predicted(scan.time)));
  const ScanSightings& found =
      newest_.emplace(front_end_.add(believed, product(predicted, beam_weights)));
  tracker_.update(found);

  const std::vector<float> on_people =
      probabilities_of_people(tracker_, believed, found.local_from_robot);
  front_end_.remember(found, surely_on_people(on_people));
  scans_.push_back({found.view.scan(), found.local_from_robot});
  history_.add(scans_.size() - 1, tracker_.people());
  return weights(on_people);
}

template <class Tracker>
std::vector<bool> TrackingFilter<Tracker>::surely_on_people(
    const std::vector<float>& on_people) const {
  std::vector<bool> surely(on_people.size());
  std::transform(on_people.begin(), on_people.end(), surely.begin(),
                 [&](float q) { return q > 0.0F && q >= options_.sure; });
  return surely;
}

// The same scans again, the last one first, by a clock that runs backwards.
template <class Tracker>
std::vector<TrackHistory::States> TrackingFilter<Tracker>::followed_back() const {
  Tracker tracker(options_.tracker, learned_, rng_.stream("backward"));
  RecentScans later(options_.front_end.recent);
  TrackHistory history;
  for (std::size_t k = scans_.size(); k-- > 0;) {
    ScanSightings scan = mirrored_in_time(scans_[k]);
    scan.features = leg_features(scan.view, options_.front_end.features);
    find_sightings(scan, later, options_.front_end);
    tracker.predict(scan.time());
    tracker.update(scan);
    std::vector<FollowedPerson> people = tracker.people();
    for (FollowedPerson& person : people) person.velocity = -person.velocity;
    history.add(k, people);
    later.add(scan.view, scan.local_from_robot,
              surely_on_people(
                  probabilities_of_people(tracker, scan.view.scan(), scan.local_from_robot)));
  }
  return history.people();
}

// (3.9) and (3.10): q of each beam. With boxes: whether it ends in one.
template <class Tracker>
std::vector<float> TrackingFilter<Tracker>::probabilities_of_people(
    const Tracker& tracker, const LaserScan& scan, const Pose2& local_from_robot) const {
  std::vector<float> on_people(scan.ranges.size(), 0.0F);
  const std::vector<FollowedPerson> people = tracker.people();
  if (std::none_of(people.begin(), people.end(), [](const auto& p) { return p.is_confirmed; })) {
    return on_people;
  }
  const bool boxes = options_.alignment == PeopleInAlignment::boxes;
  for (std::size_t b = 0; b < on_people.size(); ++b) {
    if (!scan.is_hit(b)) continue;
    const Eigen::Vector2d end = local_from_robot * scan.point_on(b, scan.ranges[b]);
    double nobody = 1.0;
    for (std::size_t i = 0; i < people.size(); ++i) {
      if (!people[i].is_confirmed) continue;
      const Eigen::Vector2d off = (end - people[i].position).cwiseAbs();
      const double reach = options_.footprint + kSpreads * std::sqrt(people[i].covariance.trace());
      if (boxes) {
        if (off.maxCoeff() <= options_.alignment_box) nobody = 0.0;
      } else if (off.maxCoeff() <= reach) {
        nobody *= 1.0 - tracker.mass_near(i, end, options_.footprint);
      }
    }
    on_people[b] = static_cast<float>(1.0 - nobody);
  }
  return on_people;
}

template <class Tracker>
std::vector<float> TrackingFilter<Tracker>::weights(const std::vector<float>& on_people) const {
  std::vector<float> weights(on_people.size(), 1.0F);
  if (options_.alignment == PeopleInAlignment::none) return weights;
  for (std::size_t b = 0; b < weights.size(); ++b) {
    weights[b] = on_people[b] >= options_.sure && on_people[b] > 0.0F ? 0.0F : 1.0F - on_people[b];
  }
  return weights;
}

template <class Tracker>
FilterResult TrackingFilter<Tracker>::result(const Trajectory& map_from_robot) const {
  std::vector<TrackHistory::States> people = history_.people();
  FilterResult result{{}, tracks_of_people(scans_, people, map_from_robot), tracker_.remarks()};
  result.remarks.insert(result.remarks.begin(), remark_on(*result.tracks));
  if (options_.follow_back) {
    for (TrackHistory::States& states : followed_back()) people.push_back(std::move(states));
  }
  result.labels = labels_of_people(scans_, people, map_from_robot, options_.labels);
  return result;
}

template class TrackingFilter<SjpdafTracker>;
template class TrackingFilter<KalmanTracker>;

}  // namespace mapbed
