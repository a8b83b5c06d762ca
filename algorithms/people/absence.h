#pragma once

#include <algorithm>

#include "core/config/option.h"

namespace mapbed {

struct AbsenceOptions {
  double forget_in_view = 0.8;  // [s]
  double forget_hidden = 4.0;   // [s]
  double most_spread = 1.5;     // [m]
};

template <class Visitor>
void visit_fields(AbsenceOptions& o, Visitor&& visit) {
  visit("forget_in_view", o.forget_in_view, Unit::second, between(0.0, 60.0),
        "without being seen although nothing hides it, after which what counts is given up");
  visit("forget_hidden", o.forget_hidden, Unit::second, between(0.0, 600.0),
        "without being seen at all, after which it is given up");
  visit("most_spread", o.most_spread, Unit::meter, between(0.05, 100.0),
        "sigma of where something is, beyond which it is given up");
}

// How long something that is followed was not seen.
class Absence {
 public:
  explicit Absence(double time) : last_seen_(time), last_update_(time) {}

  // `hidden`: how likely it could not be seen.
  void update(double time, bool is_seen, double hidden) {
    constexpr double kSeenAgain = 0.5;  // of the time in which it is seen makes up for the other
    const double seconds = std::max(0.0, time - last_update_);
    last_update_ = time;
    if (is_seen) last_seen_ = time;
    in_view_ = is_seen ? std::max(0.0, in_view_ - kSeenAgain * seconds)
                       : in_view_ + (1.0 - hidden) * seconds;
  }

  double last_update() const { return last_update_; }
  double since_seen(double time) const { return time - last_seen_; }  // [s]
  double in_view() const { return in_view_; }  // [s] the same, weighed by how likely it could be

  bool is_too_long(double time, double spread, const AbsenceOptions& options) const {
    return in_view_ > options.forget_in_view || since_seen(time) > options.forget_hidden ||
           spread > options.most_spread;
  }

 private:
  double last_seen_;    // [s]
  double last_update_;  // [s]
  double in_view_ = 0.0;
};

}  // namespace mapbed
