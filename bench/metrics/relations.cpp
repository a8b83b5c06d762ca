#include "bench/metrics/relations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include "core/check.h"
#include "core/file/text_file.h"
#include "core/file/tokens.h"
#include "core/geometry/angle.h"
#include "core/input_error.h"
#include "core/statistics/moments.h"

namespace mapbed {
namespace {

constexpr std::size_t kLargestFile = std::size_t{1} << 27;  // [bytes]
constexpr double kReach = 5.0;      // [s] a stamp further outside the estimate is skipped
constexpr double kSameTime = 1e-9;  // [s] two poses closer than this have no way between them

// Poses of equal stamps in an order of their own, so that the file's order does not matter.
Trajectory sorted(Trajectory trajectory) {
  const auto key = [](const Stamped<Pose2>& p) {
    return std::make_tuple(p.time, p.pose.x, p.pose.y, p.pose.theta);
  };
  std::sort(trajectory.begin(), trajectory.end(),
            [&](const Stamped<Pose2>& a, const Stamped<Pose2>& b) { return key(a) < key(b); });
  return trajectory;
}

std::size_t first_after(const Trajectory& trajectory, double time) {
  const auto after =
      std::upper_bound(trajectory.begin(), trajectory.end(), time,
                       [](double t, const Stamped<Pose2>& stamped) { return t < stamped.time; });
  return static_cast<std::size_t>(after - trajectory.begin());
}

// Linearly between the neighbours; the outermost pose before and after the path.
Pose2 held_pose_at(const Trajectory& trajectory, double time) {
  if (trajectory.size() == 1) return trajectory.front().pose;
  const std::size_t i =
      std::clamp<std::size_t>(first_after(trajectory, time), 1, trajectory.size() - 1);
  const Stamped<Pose2>& a = trajectory[i - 1];
  const Stamped<Pose2>& b = trajectory[i];
  const double duration = b.time - a.time;
  const double fraction =
      duration > kSameTime ? std::clamp((time - a.time) / duration, 0.0, 1.0) : 1.0;
  return interpolate(a.pose, b.pose, fraction);
}

// `start` moved on as odometry did until the time at which odometry says `now`.
Pose2 carried(const Stamped<Pose2>& start, const Trajectory& odometry, const Pose2& now) {
  return start.pose * motion_between(held_pose_at(odometry, start.time), now);
}

std::optional<Pose2> robot_at(const Trajectory& estimate, const Trajectory& odometry, double time) {
  if (time < estimate.front().time - kReach || time > estimate.back().time + kReach) return {};
  if (odometry.empty()) return held_pose_at(estimate, time);

  const Pose2 now = held_pose_at(odometry, time);
  const std::size_t i = first_after(estimate, time);
  if (i == 0) return carried(estimate.front(), odometry, now);
  const Pose2 p = carried(estimate[i - 1], odometry, now);
  if (i == estimate.size()) return p;
  const Pose2 q = carried(estimate[i], odometry, now);
  const double duration = std::max(kSameTime, estimate[i].time - estimate[i - 1].time);
  const double fraction = (time - estimate[i - 1].time) / duration;
  return Pose2{p.x + fraction * (q.x - p.x), p.y + fraction * (q.y - p.y),
               normalized_angle(p.theta + fraction * angle_difference(p.theta, q.theta))};
}

constexpr const char* kLine = "a relation is 't1 t2 x y z roll pitch yaw' in s, m and rad";

Relation parsed(std::string_view line, const SourceLocation& place) {
  std::array<double, 8> field{};
  for (double& number : field) {
    const std::string_view word = next_word(line);
    if (word.empty()) throw InputError(place, "a relation has 8 numbers", kLine);
    number = number_of(word, place, kLine);
  }
  return {field[0], field[1], {field[2], field[3], normalized_angle(field[7])}};
}

}  // namespace

std::vector<Relation> load_relations(const std::string& path) {
  return parse_relations(path, read_text_file(path, kLargestFile));
}

std::vector<Relation> parse_relations(const std::string& name, std::string_view text) {
  std::vector<Relation> relations;
  std::string_view rest = text;
  for (long number = 1; !rest.empty(); ++number) {
    const std::string_view line = without_blanks(next_line(rest));
    if (line.empty() || line.starts_with('#')) continue;
    relations.push_back(parsed(line, {name, number}));
  }
  if (relations.empty()) {
    throw InputError({name}, "holds no relation", "a line is 't1 t2 x y z roll pitch yaw'");
  }
  return relations;
}

RelationsError relations_error(const Trajectory& estimate, const std::vector<Relation>& relations,
                               const Trajectory& odometry) {
  CHECK(!estimate.empty());
  const Trajectory path = sorted(estimate);
  const Trajectory dead_reckoning = sorted(odometry);

  RelationsError result;
  std::vector<double> offsets;
  std::vector<double> turns;
  for (const Relation& relation : relations) {
    const std::optional<Pose2> a = robot_at(path, dead_reckoning, relation.from_time);
    const std::optional<Pose2> b = robot_at(path, dead_reckoning, relation.to_time);
    if (!a || !b) {
      ++result.skipped;
      continue;
    }
    const Pose2 error = motion_between(relation.from_to, motion_between(*a, *b));
    offsets.push_back(std::hypot(error.x, error.y));
    turns.push_back(std::abs(error.theta));
  }

  result.count = static_cast<int>(offsets.size());
  result.mean_translation = mean_of(offsets);
  result.sigma_translation = sigma_of(offsets);
  result.mean_rotation = mean_of(turns);
  result.sigma_rotation = sigma_of(turns);
  return result;
}

}  // namespace mapbed
