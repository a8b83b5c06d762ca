#include "algorithms/segments/segment_life.h"

#include <algorithm>

namespace mapbed {
namespace {

constexpr double kSeenAgain = 0.5;  // of the time in which somebody is seen makes up for the other

}  // namespace

void SegmentLife::add_evidence(SeenBefore before) {
  if (before == SeenBefore::free) free_ += 1.0;
  if (before != SeenBefore::same) not_same_ += before == SeenBefore::free ? 1.0 : 0.5;
}

SegmentLife::SegmentLife(int id, double time, const SeenSegment& first)
    : id_(id),
      first_seen_(time),
      last_seen_(time),
      last_update_(time),
      first_(first),
      position_(first.position) {
  add_evidence(first.before);
}

void SegmentLife::update(double time, const SeenSegment& sighted,
                         const SegmentLifeOptions& options) {
  path_ += (sighted.position - position_).norm();
  position_ = sighted.position;
  is_seen_ = sighted.is_seen;
  if (is_seen_) {
    add_evidence(sighted.before);
    last_seen_ = time;
    in_view_ = std::max(0.0, in_view_ - kSeenAgain * (time - last_update_));
    seen_time_ += time - last_update_;
    const bool lasted = time - first_seen_ >= options.confirm_time - 1e-6;
    const bool came = free_ >= options.confirm_scans;
    const bool left = sighted.at_start == SeenBefore::free && not_same_ >= options.confirm_scans;
    const bool is_alone = (sighted.from_robot - first_.from_robot).norm() >= options.confirm_robot;
    const bool is_steady = seen_time_ >= options.steadiness * (time - first_seen_);
    const bool is_somebody = lasted && is_steady && (came || left) && is_alone &&
                             has_moved(options) && sighted.at_start != SeenBefore::same;
    is_confirmed_ = is_confirmed_ || is_somebody;
  } else {
    in_view_ += (1.0 - sighted.hidden) * (time - last_update_);
  }
  last_update_ = time;
}

bool SegmentLife::has_moved(const SegmentLifeOptions& options) const {
  const double away = (position_ - first_.position).norm();
  return away >= options.confirm_travel && away >= options.straightness * path_;
}

bool SegmentLife::is_over(double time, double spread, const SegmentLifeOptions& options) const {
  const double unseen = time - last_seen_;
  if (!is_confirmed_) {
    return unseen > options.forget_new || time - first_seen_ > options.confirm_within;
  }
  return in_view_ > options.forget_in_view || unseen > options.forget_hidden ||
         spread > options.most_spread;
}

}  // namespace mapbed
