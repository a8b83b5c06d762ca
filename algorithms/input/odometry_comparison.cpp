#include "algorithms/input/odometry_comparison.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "algorithms/input/time_intervals.h"
#include "algorithms/input/told_odometry.h"
#include "core/geometry/angle.h"
#include "core/statistics/quantile.h"

namespace mapbed {
namespace {

// What odometry is taken to be worth, MotionPriorOptions: a robot that nobody calibrated.
constexpr double kUsualScale = 0.1;
constexpr double kUsualTurn = 0.07;           // [rad/m]
constexpr double kUsualMount = radians(2.0);  // the heading of a laser that somebody mounted by eye

// From one scan to the next.
struct Step {
  double from = 0.0, to = 0.0;  // [s]
  Pose2 told, matched;
  bool unknown = false;  // odometry jumped in between
};

double way(const Pose2& motion) {
  return std::hypot(motion.x, motion.y);
}

// Of odometry whose stamps are late by `lag` [s].
std::vector<Step> steps_of(const ToldOdometry& odometry, const Trajectory& estimate, double lag) {
  const std::vector<double> unknown = odometry.unknown();
  std::vector<Step> steps;
  for (std::size_t i = 1; i < estimate.size(); ++i) {
    const auto &a = estimate[i - 1], &b = estimate[i];
    const std::optional<Pose2> motion = odometry.motion(a.time + lag, b.time + lag);
    if (!motion || b.time <= a.time) continue;
    const auto first = std::upper_bound(unknown.begin(), unknown.end(), a.time);
    steps.push_back({a.time, b.time, *motion, motion_between(a.pose, b.pose),
                     first != unknown.end() && *first <= b.time});
  }
  return steps;
}

std::string amount(const Pose2& off) {
  return fmt::format("{:.2f} m and {:.0f} degrees", way(off), std::abs(degrees(off.theta)));
}

// --- standing still

// What odometry did not tell while it stood still, from steps[first] to before steps[last].
struct Silence {
  std::size_t first = 0, last = 0;
  Pose2 missed;
};

std::vector<Silence> silences_in(const std::vector<Step>& steps) {
  constexpr double kStill = 1e-6;                        // [m], [rad]
  constexpr double kMovedWay = 0.15, kMovedTurn = 0.15;  // [m], [rad] clearly
  // [m/s], [rad/s] at which estimates of a robot that stands creep, where people walk by.
  constexpr double kCreep = 0.02, kCreepTurn = 0.01;
  constexpr double kLeast = 0.25;  // [s]
  std::vector<Silence> silences;
  for (std::size_t i = 0; i < steps.size();) {
    Silence silence{.first = i, .last = i, .missed = {}};
    while (silence.last < steps.size() && way(steps[silence.last].told) < kStill &&
           std::abs(steps[silence.last].told.theta) < kStill) {
      silence.missed = silence.missed * steps[silence.last].matched;
      ++silence.last;
    }
    if (silence.last == i) {
      ++i;
      continue;
    }
    const double seconds = steps[silence.last - 1].to - steps[i].from;
    const bool moved = way(silence.missed) > kMovedWay + kCreep * seconds ||
                       std::abs(silence.missed.theta) > kMovedTurn + kCreepTurn * seconds;
    if (moved && seconds >= kLeast) silences.push_back(silence);
    i = silence.last;
  }
  return silences;
}

// Whether odometry tells most of what it missed within the next steps, or jumps there.
bool catches_up(const std::vector<Step>& steps, const Silence& silence) {
  Pose2 told, matched;
  for (std::size_t i = silence.last; i < std::min(steps.size(), silence.last + 3); ++i) {
    if (steps[i].unknown) return true;
    told = told * steps[i].told;
    matched = matched * steps[i].matched;
    const Pose2 whole = silence.missed * matched;
    const Pose2 left = motion_between(told, whole);
    const bool nearer_in_way = way(left) < 0.5 * way(silence.missed) + 0.05;
    const bool nearer_in_turn = std::abs(left.theta) < 0.5 * std::abs(silence.missed.theta) + 0.05;
    if (nearer_in_way && nearer_in_turn) return true;
  }
  return false;
}

// --- slipping wheels

// Seconds over which odometry is off by more than wheels that slip mostly are.
TimeIntervals slips_in(const std::vector<Step>& steps, const std::vector<Silence>& silences,
                       Pose2& largest) {
  constexpr double kSeconds = 3.0;
  const auto was_silent = [&](double from, double to) {
    return std::any_of(silences.begin(), silences.end(), [&](const Silence& silence) {
      return steps[silence.first].from < to + 1.0 && from < steps[silence.last - 1].to + 1.0;
    });
  };
  TimeIntervals slips;
  std::size_t begin = 0;
  for (std::size_t end = 1; end <= steps.size(); ++end) {
    while (steps[end - 1].to - steps[begin].from > kSeconds && begin + 1 < end) ++begin;
    Pose2 told, matched;
    double length = 0.0, turn = 0.0;
    bool known = true;
    for (std::size_t i = begin; i < end; ++i) {
      told = told * steps[i].told;
      matched = matched * steps[i].matched;
      length += std::max(way(steps[i].told), way(steps[i].matched));
      turn += std::max(std::abs(steps[i].told.theta), std::abs(steps[i].matched.theta));
      known = known && !steps[i].unknown;
    }
    const Pose2 off = motion_between(told, matched);
    const double may_way = 0.2 + 0.3 * length + 0.1 * turn;    // [m]
    const double may_turn = 0.25 + 0.1 * length + 0.3 * turn;  // [rad]
    const bool slips_now = known && !was_silent(steps[begin].from, steps[end - 1].to) &&
                           (way(off) > may_way || std::abs(off.theta) > may_turn);
    slips.tell(steps[end - 1].to, slips_now);
    if (slips_now && way(off) / may_way + std::abs(off.theta) / may_turn >
                         way(largest) / may_way + std::abs(largest.theta) / may_turn) {
      largest = off;
    }
  }
  return slips;
}

// --- errors of all steps

// Of pieces of straight way: how much longer odometry tells them, how much it turns on them, and
// how far from its direction the scans have them.
struct Straight {
  std::vector<double> ratios;           // of what was told to what was matched
  std::vector<double> turns_per_meter;  // [rad/m]
  std::vector<double> askew;            // [rad] of the way that was matched to that which was told
};

Straight straight_pieces(const std::vector<Step>& steps) {
  constexpr double kPiece = 1.0;     // [m]
  constexpr double kStraight = 0.1;  // [rad]
  Straight pieces;
  Pose2 told, matched;
  double length = 0.0, told_length = 0.0, turn = 0.0;
  for (const Step& step : steps) {
    told = told * step.told;
    matched = matched * step.matched;
    length += way(step.matched);
    told_length += way(step.told);
    turn += std::abs(step.matched.theta);
    if (step.unknown || turn > kStraight) {
      told = matched = {};
      length = told_length = turn = 0.0;
    }
    if (length < kPiece) continue;
    pieces.ratios.push_back(told_length / length);
    // A piece that is bent leads half its turn aside.
    const double bent = 0.5 * normalized_angle(matched.theta - told.theta);
    pieces.askew.push_back(
        normalized_angle(std::atan2(matched.y, matched.x) - std::atan2(told.y, told.x) - bent));
    pieces.turns_per_meter.push_back(normalized_angle(told.theta - matched.theta) / length);
    told = matched = {};
    length = told_length = turn = 0.0;
  }
  return pieces;
}

// The median where three quarters of the values lie on one side of `usual`, and it by more than
// `least`; else none.
std::optional<double> constant_error(const std::vector<double>& values, double usual,
                                     double least) {
  constexpr std::size_t kEnough = 10;
  if (values.size() < kEnough) return {};
  const double low = quantile_of(values, 0.25) - usual, high = quantile_of(values, 0.75) - usual;
  const double middle = median_of(values);
  const bool one_side = low * high > 0.0;
  return one_side && std::abs(middle - usual) > least ? std::optional<double>(middle)
                                                      : std::optional<double>{};
}

// [s] by which odometry's stamps are late; none where that is not clear.
std::optional<double> lag_of(const ToldOdometry& odometry, const Trajectory& estimate) {
  constexpr double kLongest = 0.5, kStep = 0.02, kLeast = 0.05;  // [s]
  const auto residual = [&](double lag) -> std::optional<double> {
    double sum = 0.0, turned = 0.0;
    for (std::size_t i = 1; i < estimate.size(); ++i) {
      const auto &a = estimate[i - 1], &b = estimate[i];
      if (b.time - a.time > ToldOdometry::kLongestGap) continue;
      const std::optional<Pose2> motion = odometry.motion(a.time + lag, b.time + lag);
      if (!motion) continue;
      const double matched = motion_between(a.pose, b.pose).theta;
      const double off = normalized_angle(matched - motion->theta);
      sum += std::min(off * off, 0.01);
      turned += std::abs(matched);
    }
    return turned > 2.0 * kPi ? std::optional<double>(sum) : std::optional<double>{};
  };
  const std::optional<double> now = residual(0.0);
  if (!now) return {};
  double best_lag = 0.0, best = *now;
  for (double lag = -kLongest; lag < kLongest + 0.5 * kStep; lag += kStep) {
    const std::optional<double> sum = residual(lag);
    if (!sum || *sum >= best) continue;
    best = *sum;
    best_lag = lag;
  }
  const bool clear = std::abs(best_lag) >= kLeast && best < 0.5 * *now;
  return clear ? std::optional<double>(best_lag) : std::optional<double>{};
}

std::vector<Remark> remarks_on(const std::vector<Step>& steps, const std::vector<Silence>& silences,
                               double start) {
  std::vector<Remark> result;
  for (const Silence& silence : silences) {
    const bool late = catches_up(steps, silence);
    const TimeInterval when{steps[silence.first].from, steps[silence.last - 1].to};
    result.push_back(
        {late ? RemarkKind::odometry_stall : RemarkKind::odometry_slip,
         fmt::format("odometry stands still from {:.1f} s to {:.1f} s after the start while the "
                     "scans move by {}{}: the scans are believed",
                     when.from - start, when.to - start, amount(silence.missed),
                     late ? ", and then catches up" : " that it never tells"),
         when});
  }
  return result;
}

std::vector<Remark> remarks_on_all_steps(const std::vector<Step>& steps) {
  std::vector<Remark> result;
  const Straight straight = straight_pieces(steps);
  if (const auto ratio = constant_error(straight.ratios, 1.0, kUsualScale)) {
    result.push_back({RemarkKind::odometry_scale,
                      fmt::format("odometry tells {:.2f} m for each metre that the scans see: the "
                                  "scans are believed",
                                  *ratio)});
  }
  if (const auto turn = constant_error(straight.turns_per_meter, 0.0, kUsualTurn)) {
    result.push_back({RemarkKind::odometry_drift,
                      fmt::format("odometry turns by {:.1f} degrees a metre where the scans drive "
                                  "straight: the scans are believed",
                                  degrees(*turn))});
  }
  if (const auto askew = constant_error(straight.askew, 0.0, kUsualMount)) {
    result.push_back(
        {RemarkKind::laser_mount,
         fmt::format("by the scans the robot drives askew, {:.1f} degrees to its {}: "
                     "the laser looks as much to the other side of where the log says; "
                     "state the mount with log.robot_from_laser",
                     std::abs(degrees(*askew)), *askew > 0.0 ? "left" : "right")});
  }
  return result;
}

}  // namespace

std::vector<Remark> remarks_on_odometry(const SensorLog& log, const Trajectory& estimate) {
  const ToldOdometry odometry(log);
  const std::optional<double> lag = lag_of(odometry, estimate);
  const std::vector<Step> steps = steps_of(odometry, estimate, lag.value_or(0.0));
  if (steps.empty()) return {};
  const double start = time_of(log.front());
  const std::vector<Silence> silences = silences_in(steps);
  std::vector<Remark> result = remarks_on(steps, silences, start);
  const auto add = [&result](const std::vector<Remark>& more) {
    result.insert(result.end(), more.begin(), more.end());
  };
  Pose2 largest;
  const TimeIntervals slips = slips_in(steps, silences, largest);
  add(remarks_on(slips, RemarkKind::odometry_slip, start,
                 fmt::format("odometry and scans differ, by up to {} in 3 s,", amount(largest)),
                 ": the scans are believed"));
  add(remarks_on_all_steps(steps));
  if (lag) {
    add({{RemarkKind::odometry_lag, fmt::format("odometry is {:.2f} s {} by its stamps",
                                                std::abs(*lag), *lag > 0.0 ? "late" : "early")}});
  }
  return result;
}

}  // namespace mapbed
