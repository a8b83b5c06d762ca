#include "algorithms/segments/segment_life.h"

namespace mapbed {

void SegmentLife::add_evidence(SeenBefore before) {
  if (before == SeenBefore::free) free_ += 1.0;
  if (before != SeenBefore::same) not_same_ += before == SeenBefore::free ? 1.0 : 0.5;
}

SegmentLife::SegmentLife(int id, double time, const SeenSegment& first)
    : id_(id), first_seen_(time), absence_(time), first_(first), position_(first.position) {
  add_evidence(first.before);
}

void SegmentLife::update(double time, const SeenSegment& sighted,
                         const SegmentLifeOptions& options) {
  path_ += (sighted.position - position_).norm();
  position_ = sighted.position;
  is_seen_ = sighted.is_seen;
  const double seconds = time - absence_.last_update();
  absence_.update(time, is_seen_, sighted.hidden);
  if (is_seen_) {
    add_evidence(sighted.before);
    seen_time_ += seconds;
    const bool lasted = time - first_seen_ >= options.confirm_time - 1e-6;
    const bool came = free_ >= options.confirm_scans;
    const bool left = sighted.at_start == SeenBefore::free && not_same_ >= options.confirm_scans;
    const bool is_alone = (sighted.from_robot - first_.from_robot).norm() >= options.confirm_robot;
    const bool is_steady = seen_time_ >= options.steadiness * (time - first_seen_);
    const bool is_somebody = lasted && is_steady && (came || left) && is_alone &&
                             has_moved(options) && sighted.at_start != SeenBefore::same;
    is_confirmed_ = is_confirmed_ || is_somebody;
  }
}

bool SegmentLife::has_moved(const SegmentLifeOptions& options) const {
  const double away = (position_ - first_.position).norm();
  return away >= options.confirm_travel && away >= options.straightness * path_;
}

bool SegmentLife::is_over(double time, double spread, const SegmentLifeOptions& options) const {
  if (is_confirmed_) return absence_.is_too_long(time, spread, options.absence);
  return absence_.since_seen(time) > options.forget_new ||
         time - first_seen_ > options.confirm_within;
}

}  // namespace mapbed
