#include "algorithms/rbpf/front_end.h"

#include <cmath>

namespace mapbed {
namespace {

std::optional<Pose2> motion_since(const std::optional<Pose2>& before,
                                  const std::optional<Pose2>& now) {
  return before && now ? std::optional<Pose2>(motion_between(*before, *now))
                       : std::optional<Pose2>{};
}

}  // namespace

FrontEnd::FrontEnd(const FrontEndOptions& options) : options_(options), matcher_(options.matcher) {}

void FrontEnd::add(const Odometry& odometry) {
  odometry_.add(odometry);
  matcher_.add(odometry);
}

void FrontEnd::forget_past() {
  matcher_.forget_past(!newest_.held_out);
}

bool FrontEnd::is_due(const Pose2& track) const {
  if (updates_.empty()) return true;
  const Pose2 motion = motion_between(updates_.back().track_from_robot, track);
  return std::hypot(motion.x, motion.y) >= options_.update_distance ||
         std::abs(motion.theta) >= options_.update_turn;
}

FrontEnd::Place FrontEnd::place_of(const LaserScan& scan, std::span<const float> beam_weights,
                                   const std::optional<Pose2>& step) {
  const Pose2 carried = track_from_robot_ * step.value_or(Pose2{});
  if (options_.proposal == Proposal::odometry) return {carried, carried};
  const bool carried_far = !updates_.empty() && is_due(carried);
  const bool condensed = condensed_scans_ > 0 || options_.proposal == Proposal::scan_matching;
  if (carried_far && condensed) {
    const ScanMatch match = matcher_.match(scan, beam_weights);
    return {.track = match.other_prediction.value_or(carried),
            .seen = match.map_from_robot,
            .held_out = true,
            .contradicts_step = match.contradicts_prediction,
            .predicted = match.other_prediction,
            .matched = match.trustworthy};
  }
  matcher_.add(scan, beam_weights);
  const ScanMatch& match = matcher_.last_match();
  return {.track = matcher_.pose(),
          .seen = matcher_.pose(),
          .held_out = false,
          .contradicts_step = match.contradicts_prediction,
          .predicted = match.other_prediction,
          .matched = match.trustworthy};
}

UpdateMotion FrontEnd::motion_to(const Place& place, const std::optional<Pose2>& step,
                                 const std::optional<Pose2>& odometry, double time) const {
  if (updates_.empty()) return {};
  const Update& before = updates_.back();
  const bool condensed = is_condensed();
  const Pose2& condensed_to = condensed ? track_from_robot_ : before.seen_from_robot;
  const std::optional<Pose2> by_odometry = condensed ? step : motion_since(at_update_, odometry);
  return {.whole = motion_between(before.track_from_robot, place.track),
          .condensed = condensed ? motion_between(before.seen_from_robot, condensed_to) : Pose2{},
          .condensed_doubt =
              condensed ? matcher_.blind_spread(condensed_scans_, scans_.back().time - before.time)
                        : std::nullopt,
          .step = place.predicted ? motion_between(condensed_to, *place.predicted) : by_odometry,
          .seconds = time - scans_.back().time,
          .guess = motion_between(before.seen_from_robot, place.seen),
          .guess_is_doubtful = !place.matched || !all_matched_,
          .step_contradicted = place.contradicts_step};
}

FrontEnd::Result FrontEnd::add(const LaserScan& scan, std::span<const float> beam_weights) {
  const std::optional<Pose2> odometry =
      options_.matcher.use_odometry ? odometry_.at(scan.time) : std::optional<Pose2>{};
  Result result{.step = motion_since(at_scan_, odometry)};
  at_scan_ = odometry;
  const bool unmoved = options_.proposal == Proposal::odometry && !scans_.empty() && !result.step;
  if (unmoved) ++unmoved_scans_;

  const std::optional<Pose2> step = motion_since(at_matched_scan_, odometry);
  const Place place = place_of(scan, beam_weights, step);
  result.fits = scans_.empty() || (place.matched && !place.contradicts_step);
  if (is_due(place.track)) {
    result.update = motion_to(place, step, odometry, scan.time);
    updates_.push_back({.time = scan.time,
                        .track_from_robot = place.track,
                        .seen_from_robot = place.seen,
                        .condensed = result.update->condensed,
                        .condensed_until = scans_.empty() ? scan.time : scans_.back().time,
                        .is_condensed = place.held_out && is_condensed()});
    at_update_ = odometry;
    condensed_scans_ = 0;
    all_matched_ = true;
  } else {
    ++condensed_scans_;
    all_matched_ = all_matched_ && place.matched;
  }
  if (!place.held_out) {
    track_from_robot_ = place.track;
    at_matched_scan_ = odometry;
  }
  newest_ = place;
  scans_.push_back({scan.time, place.seen, updates_.size(), result.update.has_value()});
  return result;
}

}  // namespace mapbed
