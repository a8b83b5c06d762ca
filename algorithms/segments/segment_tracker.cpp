#include "algorithms/segments/segment_tracker.h"

#include <algorithm>
#include <limits>

#include "algorithms/people/front_end/occlusion.h"

namespace mapbed {
namespace {

constexpr double kSpreads = 2.0;       // sigmas of a prediction, beyond the gate
constexpr double kMostGrowth = 2.0;    // of something long, of which a part was seen at first
constexpr double kBesides = 0.5;       // of the gate, for what was never looked at before
constexpr double kShrink = 0.9;        // of a box from scan to scan, when less of it is seen
constexpr double kSigma = 0.08;        // [m] of a middle of something small
constexpr double kSigmaOfSide = 0.25;  // and by how much more, of half its side
constexpr double kLeastRadius = 0.15;  // [m] of something, when it is looked for
constexpr double kMostRadius = 1.0;    // [m]
constexpr double kMarginOfBox = 0.1;   // [m] in which beams of the next scan are expected

double longest_side(const Eigen::AlignedBox2d& box) {
  return box.sizes().maxCoeff();
}

}  // namespace

Eigen::AlignedBox2d SegmentTracker::Track::box() const {
  const Eigen::Vector2d middle = state.mean.head<2>();
  return {middle - half, middle + half};
}

void SegmentTracker::predict(double time) {
  const double seconds = has_begun_ ? std::max(0.0, time - time_) : 0.0;
  has_begun_ = true;
  time_ = time;
  for (Track& track : tracks_) track.state.predict(seconds, options_.acceleration);
}

// [m] within which a segment may be a part of something although nobody looked there before.
double SegmentTracker::besides() const {
  return kBesides * options_.gate;
}

// The longest side that something may have by what did not surely come with it. [m]
double SegmentTracker::may_grow_to(const Track& track) const {
  const double side =
      track.life.is_confirmed() ? kMostGrowth * track.side + besides() : track.side + options_.gate;
  return std::min(options_.largest, side);
}

// Whether a segment may be a part of what is followed, of which those in the box `found` are. Where
// earlier scans saw through, all near it may; where nobody looked before, what makes it little
// larger than it was, for that may be a wall that comes into view; where something stood, what lies
// within something that counts: it may have stood there itself, before that was known.
bool SegmentTracker::may_be_of(const Track& track, const ScanSegment& segment,
                               const Eigen::AlignedBox2d& found) const {
  const Eigen::AlignedBox2d box = track.box();
  const double off = box.exteriorDistance(segment.box);
  switch (segment.before) {
    case SeenBefore::free:
      return off <= options_.gate + kSpreads * track.state.longest_sigma() &&
             longest_side(box.merged(segment.box)) <= options_.largest;
    case SeenBefore::nothing:
      return off <= besides() && longest_side(found.merged(segment.box)) <=
                                     std::min(longest_side(box) + besides(), may_grow_to(track));
    case SeenBefore::mixed:
    case SeenBefore::same:
      return track.life.is_confirmed() && box.contains(segment.box);
  }
  return false;
}

// The segments of each track: each goes to the one whose middle it is nearest to, those that came
// for sure first.
std::vector<std::vector<std::size_t>> SegmentTracker::assigned(const SegmentedScan& scan) const {
  std::vector<std::vector<std::size_t>> segments(tracks_.size());
  std::vector<Eigen::AlignedBox2d> found(tracks_.size());
  const auto assign = [&](std::size_t j) {
    const ScanSegment& segment = scan.segments[j];
    std::size_t nearest = tracks_.size();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
      const Track& track = tracks_[i];
      const double away = segment.box.exteriorDistance(Eigen::Vector2d(track.state.mean.head<2>()));
      if (away >= least || !may_be_of(track, segment, found[i])) continue;
      least = away;
      nearest = i;
    }
    if (nearest == tracks_.size()) return;
    segments[nearest].push_back(j);
    found[nearest].extend(segment.box);
  };
  for (const bool is_free : {true, false}) {
    for (std::size_t j = 0; j < scan.segments.size(); ++j) {
      if ((scan.segments[j].before == SeenBefore::free) == is_free) assign(j);
    }
  }
  for (std::size_t i = 0; i < tracks_.size(); ++i) add_rest(tracks_[i], scan, segments[i]);
  return segments;
}

// Of something long that counts, what covers a place that it covered before it counted: the rest of
// the piece that ranges do not cut, where that does not make it much longer. A wall beside somebody
// would.
void SegmentTracker::add_rest(const Track& track, const SegmentedScan& scan,
                              std::vector<std::size_t>& segments) const {
  if (!track.life.is_confirmed()) return;
  const std::vector<std::size_t> surely = segments;
  for (std::size_t j = 0; j < scan.segments.size(); ++j) {
    const ScanSegment& segment = scan.segments[j];
    const bool touches = std::any_of(surely.begin(), surely.end(), [&](std::size_t k) {
      return scan.segments[k].piece == segment.piece;
    });
    if (segment.before != SeenBefore::same || !touches ||
        std::find(surely.begin(), surely.end(), j) != surely.end() ||
        longest_side(track.box().merged(segment.box)) > may_grow_to(track)) {
      continue;
    }
    segments.push_back(j);
  }
}

void SegmentTracker::see(Track& track, const SegmentedScan& scan,
                         const std::vector<std::size_t>& segments) {
  const Pose2 robot_from_local = inverse(scan.local_from_robot);
  SeenSegment sighted{.is_seen = !segments.empty()};
  sighted.hidden =
      hidden_probability(scan.view, robot_from_local * Eigen::Vector2d(track.state.mean.head<2>()),
                         std::clamp(track.half.minCoeff(), kLeastRadius, kMostRadius));
  Eigen::AlignedBox2d box;
  track.beams.clear();
  for (const std::size_t j : segments) {
    const ScanSegment& segment = scan.segments[j];
    box.extend(segment.box);
    if (segment.before == SeenBefore::free) sighted.before = SeenBefore::free;
    track.beams.insert(track.beams.end(), segment.beams.begin(), segment.beams.end());
  }
  if (sighted.is_seen) {
    const Eigen::Vector2d half = box.sizes() / 2.0;
    track.state.correct(box.center(), kSigma + kSigmaOfSide * half.maxCoeff());
    track.half = half.cwiseMax(kShrink * track.half);
    if (!track.life.is_confirmed()) track.side = longest_side(track.box());
  }
  sighted.position = track.state.mean.head<2>();
  sighted.from_robot = robot_from_local * sighted.position;
  sighted.at_start = seen_again_at(scan.view, robot_from_local * track.life.start());
  track.life.update(scan.view.scan().time, sighted, options_.life);
}

// Of what came to where nothing was: segments near each other are one thing.
void SegmentTracker::begin_tracks(const SegmentedScan& scan, const std::vector<bool>& is_taken) {
  std::vector<std::size_t> left;
  for (std::size_t j = 0; j < scan.segments.size(); ++j) {
    if (!is_taken[j] && scan.segments[j].before == SeenBefore::free) left.push_back(j);
  }
  while (!left.empty()) {
    Eigen::AlignedBox2d box = scan.segments[left.back()].box;
    std::vector<std::size_t> beams = scan.segments[left.back()].beams;
    left.pop_back();
    for (std::size_t k = 0; k < left.size();) {
      const ScanSegment& other = scan.segments[left[k]];
      if (box.exteriorDistance(other.box) > options_.join ||
          longest_side(box.merged(other.box)) > options_.largest) {
        ++k;
        continue;
      }
      box.extend(other.box);
      beams.insert(beams.end(), other.beams.begin(), other.beams.end());
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(k));
      k = 0;  // the box has grown
    }
    if (beams.size() < static_cast<std::size_t>(options_.least_beams)) continue;
    const Eigen::Vector2d half = box.sizes() / 2.0;
    const Eigen::Vector2d middle = box.center();
    const SeenSegment first{.is_seen = true,
                            .before = SeenBefore::free,
                            .at_start = SeenBefore::same,
                            .position = middle,
                            .from_robot = inverse(scan.local_from_robot) * middle};
    tracks_.push_back({ConstantVelocity::at(middle, kSigma + kSigmaOfSide * half.maxCoeff(),
                                            options_.speed_sigma),
                       SegmentLife(next_id_++, scan.view.scan().time, first), half,
                       longest_side(box), std::move(beams)});
  }
}

void SegmentTracker::update(const SegmentedScan& scan) {
  const std::vector<std::vector<std::size_t>> segments = assigned(scan);
  std::vector<bool> is_taken(scan.segments.size(), false);
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    see(tracks_[i], scan, segments[i]);
    for (const std::size_t j : segments[i]) is_taken[j] = true;
  }
  std::erase_if(tracks_, [&](const Track& track) {
    return track.life.is_over(scan.view.scan().time, track.state.longest_sigma(), options_.life);
  });
  begin_tracks(scan, is_taken);
}

std::vector<FollowedPerson> SegmentTracker::followed() const {
  std::vector<FollowedPerson> followed;
  for (const Track& track : tracks_) {
    followed.push_back({track.life.id(), track.state.mean.head<2>(), track.state.mean.tail<2>(),
                        track.state.covariance.topLeftCorner<2, 2>(), track.life.is_seen(),
                        track.life.is_confirmed()});
  }
  return followed;
}

std::vector<Eigen::AlignedBox2d> SegmentTracker::boxes() const {
  std::vector<Eigen::AlignedBox2d> boxes;
  for (const Track& track : tracks_) {
    if (!track.life.is_confirmed()) continue;
    const Eigen::Vector2d margin =
        Eigen::Vector2d::Constant(kMarginOfBox + track.state.longest_sigma());
    boxes.emplace_back(track.box().min() - margin, track.box().max() + margin);
  }
  return boxes;
}

std::vector<SegmentTracker::Met> SegmentTracker::met() const {
  std::vector<Met> met;
  for (const Track& track : tracks_) {
    for (const std::size_t beam : track.beams) {
      met.push_back({track.life.id(), beam, track.life.is_confirmed()});
    }
  }
  return met;
}

}  // namespace mapbed
