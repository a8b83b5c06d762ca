#include "core/geometry/tum_file.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "core/file/text_file.h"
#include "core/file/tokens.h"
#include "core/geometry/angle.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr std::size_t kLargestFile = std::size_t{1}
                                     << 27;  // [bytes] poses take up to eight times it
constexpr const char* kLines = "lines are `t x y z qx qy qz qw` or `t x y theta`";

std::vector<double> numbers_of(std::string_view line, const SourceLocation& place) {
  std::vector<double> numbers;
  for (auto word = next_word(line); !word.empty() && word[0] != '#'; word = next_word(line))
    numbers.push_back(number_of(word, place, kLines));
  return numbers;
}

// Direction of the turned x axis, seen from above: column (1 - 2(y^2 + z^2), 2(xy + wz)).
double heading(double x, double y, double z, double w) {
  return std::atan2(2.0 * (x * y + w * z), 1.0 - 2.0 * (y * y + z * z));
}

Stamped<Pose2> pose_of(const std::vector<double>& n, const SourceLocation& place) {
  if (n.size() == 4) return {n[0], {n[1], n[2], normalized_angle(n[3])}};
  if (n.size() != 8) throw InputError(place, fmt::format("has {} numbers", n.size()), kLines);
  const double length = std::sqrt(n[4] * n[4] + n[5] * n[5] + n[6] * n[6] + n[7] * n[7]);
  if (!(std::abs(length - 1.0) <= 0.01))
    throw InputError(place, fmt::format("the quaternion has length {:.3g}, not 1", length),
                     "its order is qx qy qz qw");
  return {n[0], {n[1], n[2], heading(n[4] / length, n[5] / length, n[6] / length, n[7] / length)}};
}

}  // namespace

Trajectory parse_trajectory(const std::string& name, std::string_view text) {
  Trajectory trajectory;
  SourceLocation place{name, 0};
  while (!text.empty()) {
    ++place.line;
    const std::string_view line = next_line(text);
    const std::vector<double> numbers = numbers_of(line, place);
    if (!numbers.empty()) trajectory.push_back(pose_of(numbers, place));
  }
  if (trajectory.empty()) throw InputError({name}, "holds no pose", kLines);
  std::stable_sort(
      trajectory.begin(), trajectory.end(),
      [](const Stamped<Pose2>& a, const Stamped<Pose2>& b) { return a.time < b.time; });
  return trajectory;
}

Trajectory load_trajectory(const std::string& path) {
  return parse_trajectory(path, read_text_file(path, kLargestFile));
}

std::string tum_text(const Trajectory& trajectory) {
  fmt::memory_buffer text;
  for (const auto& [time, pose] : trajectory)
    fmt::format_to(std::back_inserter(text), "{:.6f} {:.9f} {:.9f} 0 0 0 {:.9f} {:.9f}\n", time,
                   pose.x, pose.y, std::sin(pose.theta / 2), std::cos(pose.theta / 2));
  return fmt::to_string(text);
}

void write_trajectory(const std::string& path, const Trajectory& trajectory) {
  write_text_file(path, tum_text(trajectory));
}

}  // namespace mapbed
