#include "algorithms/people/track_life.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mapbed {
namespace {

constexpr double kHimself = 0.5;   // [m] from where he was: what stood there was he
constexpr double kAway = 0.5;      // [m] from where he was: he left that place
constexpr double kWay = 6.0;       // [s] that his way is known
constexpr double kTick = 0.09;     // [s] between moments of it
constexpr double kSameTime = 0.3;  // [s] of a past scan and a moment of his way
constexpr double kNewPlace = 0.3;  // [m] from the place of the step before
constexpr double kJump = 0.15;     // [m] from where he is held to be to where he is sighted
constexpr double kMostOdds = 9.0;  // in logarithms: a person may turn out to be none in the end

double log_odds_of(double probability) {
  return std::log(probability / (1.0 - probability));
}

}  // namespace

TrackLife::TrackLife(int id, double time, const Eigen::Vector2d& position,
                     const TrackLifeOptions& options)
    : id_(id),
      absence_(time),
      log_odds_(log_odds_of(options.prior)),
      start_(position),
      way_{{time, position}},
      place_(position) {}

void TrackLife::recall(const PastScans& past) {
  then_.assign(past.times.size(), Eigen::Vector2d::Constant(std::nan("")));
  auto place = way_.begin();
  for (std::size_t i = 0; i < past.times.size(); ++i) {
    const double time = past.times[i];
    while (place != way_.end() && place->time < time - 1e-6) ++place;
    const auto nearest = place == way_.end() ? way_.end() - 1 : place;
    if (std::abs(nearest->time - time) <= kSameTime) then_[i] = nearest->position;
  }
}

SeenBefore TrackLife::before(const PastScans& past, const Sighting& sighting) const {
  ScanBits himself = 0;
  for (std::size_t i = 0; i < then_.size(); ++i) {
    if ((then_[i] - sighting.position).norm() < kHimself) himself |= ScanBits{1} << i;
  }
  return past.verdict(sighting.place, himself);
}

Evidence::Left TrackLife::left(const ScanSightings& scan) const {
  const Eigen::Vector2d& now = way_.back().position;
  const Place* farthest = nullptr;
  double most = kAway;
  for (const Place& place : way_) {
    const double away = (place.position - now).norm();
    if (away < most) continue;
    farthest = &place;
    most = away;
  }
  if (farthest == nullptr) return Evidence::Left::nowhere;
  const SeenBefore there = scan.at(farthest->position);
  if (there == SeenBefore::nothing) return Evidence::Left::unknown;
  return there == SeenBefore::free ? Evidence::Left::free : Evidence::Left::same;
}

// What the newest scan says that was not said before.
std::optional<Evidence> TrackLife::evidence(const ScanSightings& scan, const Sighting* sighting,
                                            const TrackLifeOptions& options) {
  const bool is_new = sighting != nullptr && (way_.back().position - place_).norm() >= kNewPlace;
  if (!is_new && since_evidence_ < options.memory) return {};
  since_evidence_ = 0.0;
  const bool was_steady = std::exchange(is_steady_, true);
  if (sighting == nullptr) return Evidence{.kind = Evidence::Kind::missed};
  const SeenBefore before = this->before(scan.past, *sighting);
  if (!is_new) return Evidence{.kind = Evidence::Kind::stay, .before = before};
  place_ = way_.back().position;
  return Evidence{
      .kind = Evidence::Kind::step, .before = before, .left = left(scan), .is_steady = was_steady};
}

std::optional<Evidence> TrackLife::update(const ScanSightings& scan, const Sighting* sighting,
                                          double hidden, const Eigen::Vector2d& position,
                                          const TrackLifeOptions& options,
                                          const LearnedPeople& learned) {
  const double seconds = std::max(0.0, scan.time() - absence_.last_update());
  is_seen_ = sighting != nullptr;
  absence_.update(scan.time(), is_seen_, hidden);
  if (scan.time() - way_.back().time >= kTick) {
    way_.push_back({scan.time(), position});
    while (scan.time() - way_.front().time > kWay) way_.pop_front();
  }
  since_evidence_ += is_seen_ ? seconds : (1.0 - hidden) * seconds;
  if (is_seen_) {
    is_steady_ = is_steady_ && (position - sighting->position).norm() < kJump;
  } else {
    is_steady_ = is_steady_ && hidden > 0.5;
  }
  const std::optional<Evidence> found = evidence(scan, sighting, options);
  // Who counts as a person stays one while he stands.
  const bool stands = is_confirmed_ && found && found->kind == Evidence::Kind::stay &&
                      found->before != SeenBefore::same;
  if (found && !stands) log_odds_ = std::min(kMostOdds, log_odds_ + learned.log_ratio(*found));
  if (!is_seen_) return found;
  const bool went = (position - start_).norm() >= options.confirm_travel;
  is_confirmed_ = is_confirmed_ || (went && probability() >= options.confirm);
  return found;
}

double TrackLife::probability() const {
  return 1.0 / (1.0 + std::exp(-log_odds_));
}

bool TrackLife::is_over(double time, double spread, const TrackLifeOptions& options) const {
  if (probability() < options.give_up) return true;
  if (is_confirmed_) return absence_.is_too_long(time, spread, options.absence);
  return is_missed(options) || absence_.since_seen(time) > options.absence.forget_hidden;
}

}  // namespace mapbed
