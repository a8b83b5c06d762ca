#include "bench/metrics/trajectory_error.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

#include "core/check.h"
#include "core/geometry/angle.h"
#include "core/statistics/moments.h"
#include "core/statistics/quantile.h"

namespace mapbed {
namespace {

using IndexPairs = std::vector<std::pair<std::size_t, std::size_t>>;

// The pose nearest in time; of two as near, the earlier one.
const Stamped<Pose2>& nearest(const Trajectory& sorted, double time) {
  const auto after =
      std::lower_bound(sorted.begin(), sorted.end(), time,
                       [](const Stamped<Pose2>& stamped, double t) { return stamped.time < t; });
  if (after == sorted.begin()) return *after;
  const auto before = after - 1;
  if (after == sorted.end()) return *before;
  return after->time - time < time - before->time ? *after : *before;
}

PosePair pair_of(const Stamped<Pose2>& truth, const Stamped<Pose2>& estimate) {
  return {estimate.time, truth.pose, estimate.pose};
}

// How far along the path each pose lies [m].
std::vector<double> path_lengths(const std::vector<Pose2>& path) {
  std::vector<double> lengths(path.size(), 0.0);
  for (std::size_t i = 1; i < path.size(); ++i) {
    lengths[i] = lengths[i - 1] + distance(path[i - 1], path[i]);
  }
  return lengths;
}

IndexPairs pairs_by_frames(std::size_t count, std::size_t delta, bool all_pairs) {
  IndexPairs pairs;
  for (std::size_t i = 0; i + delta < count; i += all_pairs ? 1 : delta) {
    pairs.emplace_back(i, i + delta);
  }
  return pairs;
}

// The end nearest to delta from every start on.
IndexPairs all_pairs_by_length(const std::vector<double>& lengths, double delta, double slack) {
  IndexPairs pairs;
  for (std::size_t i = 0; i + 1 < lengths.size(); ++i) {
    const double goal = lengths[i] + delta;
    const auto first = lengths.begin() + static_cast<std::ptrdiff_t>(i) + 1;
    auto end = std::lower_bound(first, lengths.end(), goal);
    if (end == lengths.end() || (end != first && goal - *(end - 1) <= *end - goal)) --end;
    end = std::lower_bound(first, end, *end);  // the first of equal lengths: the robot stood
    if (std::abs(*end - goal) > slack) continue;
    pairs.emplace_back(i, static_cast<std::size_t>(end - lengths.begin()));
  }
  return pairs;
}

// Cuts the path each time that delta is reached; the piece before the first cut is not used.
IndexPairs chained_pairs_by_length(const std::vector<double>& lengths, double delta) {
  IndexPairs pairs;
  std::size_t last_cut = 0;
  bool has_cut = false;
  double start = 0.0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    if (lengths[i] - start < delta) continue;
    if (has_cut) pairs.emplace_back(last_cut, i);
    last_cut = i;
    has_cut = true;
    start = lengths[i];
  }
  return pairs;
}

IndexPairs index_pairs(const std::vector<PosePair>& pairs, const RelativeErrorOptions& options) {
  if (options.unit == PathUnit::frames) {
    const auto delta = static_cast<std::size_t>(options.delta);
    return pairs_by_frames(pairs.size(), delta, options.all_pairs);
  }
  std::vector<Pose2> path;
  for (const PosePair& pair : pairs) path.push_back(pair.estimate);
  const std::vector<double> lengths = path_lengths(path);
  if (!options.all_pairs) return chained_pairs_by_length(lengths, options.delta);
  return all_pairs_by_length(lengths, options.delta, options.delta * options.tolerance);
}

// Collects errors of poses or motions.
struct ErrorLists {
  std::vector<double> translation;
  std::vector<double> rotation;

  void add(const Pose2& truth, const Pose2& estimate) {
    const Pose2 error = motion_between(truth, estimate);
    translation.push_back(std::hypot(error.x, error.y));
    rotation.push_back(std::abs(error.theta));
  }
  PoseErrors statistics() && {
    return {statistics_of(std::move(translation)), statistics_of(std::move(rotation))};
  }
};

}  // namespace

std::vector<PosePair> associated(const Trajectory& truth, const Trajectory& estimate,
                                 double max_time_difference) {
  std::vector<PosePair> pairs;
  if (truth.empty() || estimate.empty()) return pairs;
  const bool estimate_is_longer = estimate.size() > truth.size();
  const Trajectory& shorter = estimate_is_longer ? truth : estimate;
  const Trajectory& longer = estimate_is_longer ? estimate : truth;
  for (const Stamped<Pose2>& stamped : shorter) {
    const Stamped<Pose2>& partner = nearest(longer, stamped.time);
    if (std::abs(partner.time - stamped.time) > max_time_difference) continue;
    pairs.push_back(estimate_is_longer ? pair_of(stamped, partner) : pair_of(partner, stamped));
  }
  return pairs;
}

ErrorStatistics statistics_of(std::vector<double> errors) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  if (errors.empty()) return {0, nan, nan, nan, nan, nan, nan};
  std::sort(errors.begin(), errors.end());
  ErrorStatistics result{.count = static_cast<int>(errors.size())};
  result.mean = mean_of(errors);
  result.rmse = root_mean_square_of(errors);
  result.sigma = sigma_of(errors);
  result.median = median_of(errors);
  result.min = errors.front();
  result.max = errors.back();
  return result;
}

Pose2 alignment(const std::vector<PosePair>& pairs) {
  if (pairs.empty()) return {};
  Eigen::Vector2d true_mean = Eigen::Vector2d::Zero();
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const PosePair& pair : pairs) {
    true_mean += pair.truth.position();
    mean += pair.estimate.position();
  }
  true_mean /= static_cast<double>(pairs.size());
  mean /= static_cast<double>(pairs.size());

  // In the plane the rotation that maximises the trace is the angle of the summed products.
  double cosine = 0.0;
  double sine = 0.0;
  for (const PosePair& pair : pairs) {
    const Eigen::Vector2d a = pair.estimate.position() - mean;
    const Eigen::Vector2d b = pair.truth.position() - true_mean;
    cosine += a.x() * b.x() + a.y() * b.y();
    sine += a.x() * b.y() - a.y() * b.x();
  }
  constexpr double same_place = 1e-12;  // [m^2] below this there is no direction to turn to
  if (std::hypot(cosine, sine) < same_place) {
    return pairs.front().truth * inverse(pairs.front().estimate);
  }
  const Pose2 turn{0.0, 0.0, std::atan2(sine, cosine)};
  const Eigen::Vector2d shift = true_mean - turn * mean;
  return {shift.x(), shift.y(), turn.theta};
}

PoseErrors absolute_error(const std::vector<PosePair>& pairs, const Pose2& world_from_map) {
  ErrorLists errors;
  for (const PosePair& pair : pairs) errors.add(pair.truth, world_from_map * pair.estimate);
  return std::move(errors).statistics();
}

PoseErrors relative_error(const std::vector<PosePair>& pairs, const RelativeErrorOptions& options) {
  CHECK(options.delta > 0.0);
  CHECK(options.unit == PathUnit::meters || options.delta >= 1.0);
  ErrorLists errors;
  for (const auto& [i, j] : index_pairs(pairs, options)) {
    errors.add(motion_between(pairs[i].truth, pairs[j].truth),
               motion_between(pairs[i].estimate, pairs[j].estimate));
  }
  return std::move(errors).statistics();
}

PoseErrors error_over_path(const Trajectory& truth, const Trajectory& estimate, double length) {
  CHECK(length > 0.0);
  std::vector<Pose2> path;
  for (const Stamped<Pose2>& stamped : truth) path.push_back(stamped.pose);
  const std::vector<double> lengths = path_lengths(path);

  ErrorLists errors;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const auto end = std::lower_bound(lengths.begin(), lengths.end(), lengths[i] + length);
    if (end == lengths.end()) break;
    const auto j = static_cast<std::size_t>(end - lengths.begin());
    const std::optional<Pose2> from = pose_at(estimate, truth[i].time);
    const std::optional<Pose2> to = pose_at(estimate, truth[j].time);
    if (!from || !to) continue;
    errors.add(motion_between(truth[i].pose, truth[j].pose), motion_between(*from, *to));
  }
  return std::move(errors).statistics();
}

}  // namespace mapbed
